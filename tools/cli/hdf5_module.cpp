// All uses of the HDF5 library are in this file.
#include "hdf5_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <hdf5.h>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

constexpr hsize_t kLargestChunk = 65536;  // rows

// The rows of one chunk, for a table of so many: space is taken by whole chunks, so a small table has a small
// one, and those of a large table are of equal size.
hsize_t chunk_of(std::int64_t rows) {
  if (rows <= 0) return kLargestChunk;
  const auto size = static_cast<hsize_t>(rows);
  const hsize_t chunks = (size + kLargestChunk - 1) / kLargestChunk;
  return (size + chunks - 1) / chunks;
}

// Thrown and caught within this file only.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

hid_t checked(hid_t id, const char* what) {
  if (id < 0) throw Failure(what);
  return id;
}

void check(herr_t status, const char* what) {
  if (status < 0) throw Failure(what);
}

// An object of the library, closed at the end of its scope.
class Handle {
public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close closing, const char* what) : id_(checked(id, what)), close_(closing) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  void close(const char* what) { check(close_(std::exchange(id_, hid_t{-1})), what); }
  operator hid_t() const {
    return id_;
  }  // NOLINT(google-explicit-constructor): to be passed on to its functions

private:
  hid_t id_;
  Close close_;
};

// A text type of `length` bytes, or of variable length (H5T_VARIABLE).
hid_t make_text_type(std::size_t length) {
  const hid_t type = checked(H5Tcopy(H5T_C_S1), "a type of text");
  check(H5Tset_size(type, length), "a type of text");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "a type of text");
  if (length != H5T_VARIABLE) {
    check(H5Tset_strpad(type, H5T_STR_NULLPAD), "a type of text");
  }
  return type;
}

void set_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle type(make_text_type(std::max<std::size_t>(text.size(), 1)), H5Tclose, "a type of text");
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "a space");
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "an attribute");
  const std::string padded = text.empty() ? std::string(1, '\0') : text;
  check(H5Awrite(attribute, type, padded.data()), "an attribute");
}

// An enumeration of the words of a column, by their index.
hid_t make_words(const Column& column) {
  const hid_t type = checked(H5Tenum_create(H5T_NATIVE_INT8), "a type of words");
  for (std::size_t i = 0; i < column.words.size(); ++i) {
    const auto value = static_cast<std::int8_t>(i);
    check(H5Tenum_insert(type, std::string(column.words[i]).c_str(), &value), "a type of words");
  }
  const std::int8_t undefined = -1;
  check(H5Tenum_insert(type, "undefined", &undefined), "a type of words");
  return type;
}

// A column that can grow. It stores no times, so that equal tables give equal bytes.
class Dataset {
public:
  Dataset(hid_t file, const std::string& name, hid_t type, hsize_t chunk) {
    const hsize_t none = 0;
    const hsize_t any = H5S_UNLIMITED;
    const Handle space(H5Screate_simple(1, &none, &any), H5Sclose, "a space");
    const Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "a list of properties");
    check(H5Pset_chunk(list, 1, &chunk), "a chunk");
    check(H5Pset_obj_track_times(list, false), "a property");
    id_.emplace(H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose,
                "a dataset");
  }

  [[nodiscard]] hid_t id() const { return *id_; }

  void append(hid_t type, const void* values, hsize_t count) {
    const hsize_t size = size_ + count;
    check(H5Dset_extent(*id_, &size), "a dataset");
    const Handle in_file(H5Dget_space(*id_), H5Sclose, "a space");
    check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, &size_, nullptr, &count, nullptr), "a space");
    const Handle in_memory(H5Screate_simple(1, &count, nullptr), H5Sclose, "a space");
    check(H5Dwrite(*id_, type, in_memory, in_file, H5P_DEFAULT, values), "a dataset");
    size_ = size;
  }

private:
  std::optional<Handle> id_;
  hsize_t size_ = 0;
};

// A column and its buffer of values not written yet.
class ColumnFile {
public:
  ColumnFile(hid_t file, const Column& column, bool is_whole, hsize_t chunk)
      : chunk_(chunk),
        is_words_(!column.words.empty()),
        type_(is_words_ ? make_words(column) : H5Tcopy(is_whole ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE),
              H5Tclose, "a type"),
        data_(file, column.name, type_, chunk) {
    if (!is_words_) set_attribute(data_.id(), "unit", column.unit);
  }

  void add(double value) {
    values_.push_back(value);
    if (values_.size() == chunk_) flush();
  }

  void flush() {
    if (is_words_) {
      std::vector<std::int8_t> words;
      words.reserve(values_.size());
      for (const double value : values_)
        words.push_back(std::isnan(value) ? std::int8_t{-1} : static_cast<std::int8_t>(value));
      data_.append(type_, words.data(), words.size());
    } else {
      data_.append(H5T_NATIVE_DOUBLE, values_.data(), values_.size());
    }
    values_.clear();
  }

private:
  hsize_t chunk_;
  bool is_words_;
  Handle type_;
  Dataset data_;
  std::vector<double> values_;
};

class Table {
public:
  Table(hid_t place, const Hdf5Columns& columns) {
    const hsize_t chunk = chunk_of(columns.rows);
    for (const Column& column : columns.columns) {
      const auto& whole = columns.integers;
      const bool is_whole = std::find(whole.begin(), whole.end(), column.name) != whole.end();
      columns_.push_back(std::make_unique<ColumnFile>(place, column, is_whole, chunk));
    }
    const Handle text(make_text_type(H5T_VARIABLE), H5Tclose, "a type of text");
    for (const std::string& name : columns.texts) {
      texts_.push_back(std::make_unique<Dataset>(place, name, text, chunk));
    }
  }

  void append(std::span<const double> values, const std::vector<std::span<const std::string>>& texts) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      columns_[i % columns_.size()]->add(values[i]);
    }
    for (std::size_t i = 0; i < texts.size(); ++i) {
      append_texts(*texts_[i], texts[i]);
    }
  }

  void flush() {
    for (const auto& column : columns_) column->flush();
  }

private:
  static void append_texts(Dataset& data, std::span<const std::string> texts) {
    const Handle type(make_text_type(H5T_VARIABLE), H5Tclose, "a type of text");
    std::vector<const char*> begins;
    begins.reserve(texts.size());
    for (const std::string& text : texts) begins.push_back(text.c_str());
    if (!begins.empty()) data.append(type, begins.data(), begins.size());
  }

  std::vector<std::unique_ptr<ColumnFile>> columns_;
  std::vector<std::unique_ptr<Dataset>> texts_;
};

class File : public Hdf5File {
public:
  explicit File(const std::string& path) {
    H5dont_atexit();                              // after a failed write its cleanup at exit would crash
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // no error messages on standard error
    attempt([&] {
      file_.emplace(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "the file");
    });
  }

  void set_attribute(const std::string& name, const std::string& text) override {
    attempt([&] { cli::set_attribute(*file_, name.c_str(), text); });
  }

  std::size_t add_table(const std::string& group, const Hdf5Columns& columns) override {
    attempt([&] {
      if (group.empty()) {
        tables_.emplace_back(*file_, columns);
        return;
      }
      const Handle place(H5Gcreate2(*file_, group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                         "a group");
      tables_.emplace_back(place, columns);
    });
    return error_.empty() ? tables_.size() - 1 : 0;
  }

  void append(std::size_t table, std::span<const double> values,
              const std::vector<std::span<const std::string>>& texts) override {
    attempt([&] { tables_[table].append(values, texts); });
  }

  void close() override {
    attempt([&] {
      for (Table& table : tables_) table.flush();
      tables_.clear();
      check(H5Fflush(*file_, H5F_SCOPE_GLOBAL), "the file");
      file_->close("the file");
    });
  }

  [[nodiscard]] const std::string& error() const override { return error_; }

private:
  // Runs `work` unless an earlier step has failed; turns exceptions into error_.
  template <class Work>
  void attempt(const Work& work) {
    if (!error_.empty()) {
      return;
    }
    try {
      work();
    } catch (const Failure& failure) {
      error_ = fmt::format("HDF5 failed at {}; is the disk full?", failure.what());
    }
  }

  std::optional<Handle> file_;
  std::vector<Table> tables_;
  std::string error_;
};

}  // namespace
}  // namespace higherpair::cli

void higherpair_create_hdf5(const std::string& path, std::unique_ptr<higherpair::cli::Hdf5File>& file) {
  file = std::make_unique<higherpair::cli::File>(path);
}
