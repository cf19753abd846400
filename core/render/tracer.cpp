#include "render/tracer.h"

#include "optics/display_primaries.h"
#include "render/chief_passes.h"

#include <tbb/blocked_range2d.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>

namespace eye_render {

namespace {

// Pixels a side: large enough for the cost of a task to vanish, small enough for two threads to
// end together and for a cancelled render to stop at once.
constexpr int tile_size = 32;

// Calls work(FilmTile&) for the tiles of the film in parallel and puts them back.
template <typename Work>
bool for_each_tile(Film& film, const std::atomic<bool>& cancelled, const Work& work)
{
    const PixelBounds& all = film.bounds();
    const int columns = (all.width() + tile_size - 1) / tile_size;
    const int rows = (all.height() + tile_size - 1) / tile_size;
    tbb::parallel_for(
        tbb::blocked_range2d<int>(0, rows, 1, 0, columns, 1),
        [&](const tbb::blocked_range2d<int>& range) {
            for (int row = range.rows().begin(); row < range.rows().end(); ++row) {
                for (int column = range.cols().begin(); column < range.cols().end(); ++column) {
                    if (cancelled.load(std::memory_order_relaxed)) {
                        return;
                    }
                    const int x0 = all.x0 + column * tile_size;
                    const int y0 = all.y0 + row * tile_size;
                    FilmTile tile = film.take({.x0 = x0,
                                               .y0 = y0,
                                               .x1 = std::min(x0 + tile_size, all.x1),
                                               .y1 = std::min(y0 + tile_size, all.y1)});
                    work(tile);
                    film.put(tile);
                }
            }
        },
        tbb::simple_partitioner{});
    return !cancelled.load();
}

// The scene is laid out relative to where the eye is half way; at other times the eye itself
// moves.
CameraRay ray_at(const RenderJob& job,
                 float time,
                 const V2d& raster,
                 const V2d& pupil_point_m,
                 double wavelength_nm)
{
    Room<CameraFrame> moved;
    if (job.camera_motion && job.moves) {
        moved.fill(job.camera_motion->at(time));
    }
    const CameraFrame& frame = moved ? *moved : job.frame;
    CameraRay camera =
        camera_ray(frame, *job.eye, frame.chief_slope(raster), pupil_point_m, wavelength_nm);
    camera.ray.origin += V3f(frame.position_world - job.frame.position_world);
    camera.ray.time = time;
    return camera;
}

float time_of(const RenderJob& job, float u) { return job.shutter ? job.shutter->sample(u) : u; }

PathSample trace_sample(const RenderJob& job,
                        int x,
                        int y,
                        std::uint32_t number,
                        PassValues* values)
{
    const auto pixel =
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(job.frame.width_px) +
        static_cast<std::uint64_t>(x);
    const std::uint64_t key = sobol_key(job.seed, pixel);
    SampleSequence sequence(key, number);
    // The pupil gets the first two dimensions, which are stratified best: its blur is wider than
    // the pixel filter.
    const auto u = sequence.next();
    PathSample sample;
    sample.x = x;
    sample.y = y;
    sample.values = values;
    if (values != nullptr) {
        values->clear();
    }
    if (job.lens) {
        sample.pupil_point_m =
            pupil_point(job.pattern, {.pixel_key = key, .number = number, .u = {u[0], u[1]}}) *
            (0.5 * job.eye->pupil_diameter_m());
    }
    const V2d raster = V2d(x + 0.5, y + 0.5) + job.filter.sample(V2f(u[2], u[3]));
    double wavelength_nm = reference_wavelength_nm;
    if (job.chromatic) {
        const WorkingSpace space = job.scene->working_space();
        wavelength_nm = sample_wavelength_nm(sequence.next()[0], space);
        sample.channel_weight =
            display_primaries(wavelength_nm, space) / wavelength_pdf(wavelength_nm, space);
    }
    const float time = job.moves ? time_of(job, sequence.next()[0]) : shutter_middle;
    const CameraRay camera = ray_at(job, time, raster, sample.pupil_point_m, wavelength_nm);
    sample.fate = camera.fate;
    if (job.stiles_crawford) {
        sample.weight = job.stiles_crawford->weight(sample.pupil_point_m);
    }
    if (camera.fate == RayFate::Transmitted) {
        sample.weight *= camera.weight;
        sample.light = trace_path(*job.scene, job.integrator, camera.ray, sequence, values);
    }
    return sample;
}

}  // namespace

void on_threads(int threads, const std::function<void()>& work)
{
    const int available = tbb::info::default_concurrency();
    tbb::task_arena arena(threads > 0 ? std::min(threads, available) : available);
    arena.execute(work);
}

bool trace_samples(const RenderJob& job,
                   const SampleRange& range,
                   Film& film,
                   const std::atomic<bool>& cancelled)
{
    return for_each_tile(film, cancelled, [&](FilmTile& tile) {
        const PixelBounds& bounds = tile.bounds();
        PassValues values(job.passes);
        PassValues* const wanted = job.passes.has_values() ? &values : nullptr;
        for (int y = bounds.y0; y < bounds.y1; ++y) {
            for (int x = bounds.x0; x < bounds.x1; ++x) {
                // Within a pixel all samples or none, so that a cancelled picture has no gaps.
                if (cancelled.load(std::memory_order_relaxed)) {
                    return;
                }
                for (std::uint32_t number = range.first; number < range.last; ++number) {
                    tile.add(trace_sample(job, x, y, number, wanted));
                }
            }
        }
    });
}

bool trace_chief_rays(const RenderJob& job, Film& film, const std::atomic<bool>& cancelled)
{
    const ChiefRays rays{.scene = *job.scene,
                         .frame = job.frame,
                         .eye = *job.eye,
                         .least_alpha = job.chief_least_alpha,
                         .camera_motion = job.camera_motion ? &*job.camera_motion : nullptr};
    return for_each_tile(film, cancelled, [&](FilmTile& tile) {
        const PixelBounds& bounds = tile.bounds();
        std::vector<float> values(job.passes.chief_channels());
        for (int y = bounds.y0; y < bounds.y1; ++y) {
            for (int x = bounds.x0; x < bounds.x1; ++x) {
                trace_chief_ray(rays, V2d(x + 0.5, y + 0.5), job.passes, values);
                tile.set(x, y, values);
            }
        }
    });
}

}  // namespace eye_render
