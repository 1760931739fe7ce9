#pragma once
#include <cstddef>
#include <functional>

namespace course {

/// Does a job for each number below `count`, in as many processes as there are cores, which end with this one. What a job
/// finds out it leaves in a file; one whose process is killed leaves nothing, and the others go on.
/// @param done  is called here, after each job that has ended
/// @throws EnvironmentError with the words of a job that has thrown; what the others have left is there
void in_parallel(std::size_t count, const std::function<void(std::size_t)> &job, const std::function<void()> &done);

} // namespace course
