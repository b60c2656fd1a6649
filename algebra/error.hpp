#pragma once

#include <stdexcept>
#include <string>

namespace limes {

/// Everything that Limes throws derives from Error. Mathematical failure (a claim that cannot be proved) is a value, never an
/// exception; exceptions say that the caller or the input is wrong, or that the work was stopped.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A position in a text: line and column count from 1; 0 means unknown.
struct SourcePosition {
  std::string file;
  int line = 0;
  int column = 0;
};

/// The input (a file, an expression, an option) is wrong. what() is the one line shown to the user:
/// "file:line:column: reason", with the parts that are known.
class InputError : public Error {
 public:
  explicit InputError(const std::string& reason, SourcePosition position = {});
  const std::string& reason() const { return reason_; }
  const SourcePosition& position() const { return position_; }
  /// The same error, moved to a position in an enclosing text (an expression inside a file). The column of the inner text is
  /// kept in the reason.
  InputError located(const std::string& file, int line) const;

 private:
  std::string reason_;
  SourcePosition position_;
};

/// An input is well-formed but exceeds a stated limit (digits, degree, nesting, budget).
class LimitError : public InputError {
 public:
  using InputError::InputError;
};

/// A precondition of a function does not hold (pole, division by zero, mismatched shapes).
class DomainError : public Error {
 public:
  using Error::Error;
};

/// The work was interrupted by the user or ran out of its budget.
class Interrupted : public Error {
 public:
  using Error::Error;
};

/// A bug in Limes: an invariant does not hold.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace limes
