#pragma once
// Zips of every kind, as strangers make them: for tests.

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <sys/stat.h>
#include <utility>
#include <vector>
#include <zip.h>

namespace course {

class MadeZip {
  public:
    MadeZip &file(const std::string &name, std::string bytes = "int x;\n") {
        return add({name, std::move(bytes), S_IFREG | 0644, false, 0});
    }
    MadeZip &special(const std::string &name, mode_t kind, std::string bytes) {
        return add({name, std::move(bytes), kind | 0777, false, 0});
    }
    MadeZip &link(const std::string &name, const std::string &to) { return special(name, S_IFLNK, to); }
    MadeZip &encrypted(const std::string &name) { return add({name, "int x;\n", S_IFREG | 0644, true, 0}); }
    /// That many zeros, of which little is left when they're packed.
    MadeZip &zeros(const std::string &name, zip_uint64_t bytes) {
        return add({name, "", S_IFREG | 0644, false, bytes});
    }

    /// Writes it, the same bytes for the same files.
    void write(const std::filesystem::path &to) const {
        std::filesystem::remove(to);
        zip_t *const zip = zip_open(to.c_str(), ZIP_CREATE, nullptr);
        if (zip == nullptr) throw std::runtime_error{"cannot make " + to.string()};
        for (const Made &each : all) {
            zip_source_t *const bytes = each.zeros > 0
                                            ? zip_source_function(zip, &zeros_of, const_cast<Made *>(&each))
                                            : zip_source_buffer(zip, each.bytes.data(), each.bytes.size(), 0);
            const zip_int64_t at = zip_file_add(zip, each.name.c_str(), bytes, ZIP_FL_ENC_UTF_8);
            if (at < 0) throw std::runtime_error{each.name + " cannot be added: " + zip_strerror(zip)};
            const auto place = static_cast<zip_uint64_t>(at);
            zip_file_set_external_attributes(zip, place, 0, ZIP_OPSYS_UNIX, each.mode << 16);
            zip_file_set_dostime(zip, place, 0, 46 << 9 | 1 << 5 | 1, 0);
            if (each.locked) zip_file_set_encryption(zip, place, ZIP_EM_AES_256, "secret");
        }
        if (zip_close(zip) != 0) throw std::runtime_error{"cannot write " + to.string() + ": " + zip_strerror(zip)};
    }

  private:
    struct Made {
        std::string name, bytes;
        mode_t mode;
        bool locked;
        zip_uint64_t zeros, given = 0;
    };

    MadeZip &add(Made made) { return all.push_back(std::move(made)), *this; }

    static zip_int64_t zeros_of(void *made, void *to, zip_uint64_t size, zip_source_cmd_t command) {
        Made &file = *static_cast<Made *>(made);
        switch (command) {
        case ZIP_SOURCE_OPEN: file.given = 0; return 0;
        case ZIP_SOURCE_READ: {
            const zip_uint64_t next = std::min(size, file.zeros - file.given);
            std::fill_n(static_cast<char *>(to), next, '\0');
            file.given += next;
            return static_cast<zip_int64_t>(next);
        }
        case ZIP_SOURCE_STAT:
            zip_stat_init(static_cast<zip_stat_t *>(to));
            static_cast<zip_stat_t *>(to)->size = file.zeros;
            static_cast<zip_stat_t *>(to)->valid = ZIP_STAT_SIZE;
            return sizeof(zip_stat_t);
        case ZIP_SOURCE_SUPPORTS:
            return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT,
                                                  ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, -1);
        default: return 0;
        }
    }

    std::vector<Made> all;
};

} // namespace course
