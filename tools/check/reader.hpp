#pragma once

namespace course {

/// Where words are read. A page has buttons for what the terminal has commands for, so no command is named there.
enum class Reader { terminal, page };

} // namespace course
