#include "runner/study/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <deque>

#include "runner/study/schema.hpp"

namespace mpmstudy {

std::string Dimension::text() const {
  std::string text;
  for (std::size_t k = 0; k < units.size(); ++k) {
    if (powers[k] == 0) continue;
    text += (text.empty() ? "" : " ") + std::string(units[k]);
    if (powers[k] != 1) text += std::to_string(powers[k]);
  }
  return text.empty() ? "1" : text;
}

namespace {

constexpr std::array<std::string_view, 16> functions = {"sin", "cos",  "tan", "asin", "acos", "atan",
                                                        "exp", "ln",   "log", "sqrt", "abs",  "min",
                                                        "max", "rint", "pow", "sign"};
constexpr std::string_view pi_name = "pi";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// Also the bytes of a micro sign.
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// A piece of the text.
struct Token {
  enum class Kind { number, name, function, other } kind;
  std::size_t at, size;
  double number = 0;
  std::string unit;  ///< of a number, as written; "" where it has none
};

/// Cuts a text. A unit is what follows a number: words with powers, joined by / . or * without a space, up to
/// the first one that is a parameter.
class Cutter {
 public:
  Cutter(std::string_view text, const std::function<bool(std::string_view)>& is_parameter)
      : text_(text), is_parameter_(is_parameter) {}

  std::vector<Token> all() {
    std::vector<Token> tokens;
    while (at_ < text_.size()) {
      const std::size_t from = at_;
      if (is_digit(text_[at_]) || (text_[at_] == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
        tokens.push_back(number());
      } else if (is_letter(text_[at_])) {
        word();
        const auto name = text_.substr(from, at_ - from);
        const bool function = std::ranges::find(functions, name) != functions.end();
        tokens.push_back({function ? Token::Kind::function : Token::Kind::name, from, at_ - from, 0, {}});
      } else {
        ++at_;
        if (text_[from] != ' ') tokens.push_back({Token::Kind::other, from, 1, 0, {}});
      }
    }
    return tokens;
  }

 private:
  void word() {
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
  }
  /// A word of a unit with its power: "s", "m3", "s^-2", "s-2" has none (that is a difference).
  bool unit_word() {
    const std::size_t from = at_;
    if (at_ >= text_.size() || !is_letter(text_[at_])) return false;
    word();
    if (is_parameter_(text_.substr(from, at_ - from))) {
      at_ = from;
      return false;
    }
    if (at_ < text_.size() && text_[at_] == '^') {
      ++at_;
      if (at_ < text_.size() && text_[at_] == '-') ++at_;
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    }
    return true;
  }
  Token number() {
    Token token{Token::Kind::number, at_, 0, 0, {}};
    const char* const end = text_.data() + text_.size();
    const auto result = std::from_chars(text_.data() + at_, end, token.number);
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    std::size_t unit = at_;
    while (unit < text_.size() && text_[unit] == ' ') ++unit;
    const std::size_t after = std::exchange(at_, unit);
    if (!unit_word()) {
      at_ = after;
    } else {
      for (std::size_t more = at_;
           at_ < text_.size() && (text_[at_] == '/' || text_[at_] == '.' || text_[at_] == '*'); more = at_) {
        ++at_;
        if (!unit_word()) {
          at_ = more;
          break;
        }
      }
      token.unit = text_.substr(unit, at_ - unit);
    }
    token.size = at_ - token.at;
    return token;
  }

  std::string_view text_;
  const std::function<bool(std::string_view)>& is_parameter_;
  std::size_t at_ = 0;
};

/// A name for the parser that is as long as the text it stands for, so that its positions are those of the
/// text: "@" and as many letters.
std::string stand_in(std::size_t number, std::size_t size) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::string name = "@";
  name += letters[number % letters.size()];
  if (number >= letters.size()) name += letters[number / letters.size() % letters.size()];
  if (name.size() < size) name.resize(size, ' ');
  return name;
}

/// Operators in place of those of the parser, which compares to the last bit.
void compare_to_12_digits(mu::Parser& parser) {
  static const auto more = [](double a, double b) {
    return a - b > 1e-12 * std::max(std::abs(a), std::abs(b));
  };
  parser.EnableBuiltInOprt(false);
  parser.DefineOprt(
      ">", [](double a, double b) { return double(more(a, b)); }, mu::prCMP);
  parser.DefineOprt(
      "<", [](double a, double b) { return double(more(b, a)); }, mu::prCMP);
  parser.DefineOprt(
      ">=", [](double a, double b) { return double(!more(b, a)); }, mu::prCMP);
  parser.DefineOprt(
      "<=", [](double a, double b) { return double(!more(a, b)); }, mu::prCMP);
  parser.DefineOprt(
      "==", [](double a, double b) { return double(!more(a, b) && !more(b, a)); }, mu::prCMP);
  parser.DefineOprt(
      "!=", [](double a, double b) { return double(more(a, b) || more(b, a)); }, mu::prCMP);
  parser.DefineOprt(
      "&&", [](double a, double b) { return double(a != 0 && b != 0); }, mu::prLAND);
  parser.DefineOprt(
      "||", [](double a, double b) { return double(a != 0 || b != 0); }, mu::prLOR);
  parser.DefineOprt(
      "+", [](double a, double b) { return a + b; }, mu::prADD_SUB);
  parser.DefineOprt(
      "-", [](double a, double b) { return a - b; }, mu::prADD_SUB);
  parser.DefineOprt(
      "*", [](double a, double b) { return a * b; }, mu::prMUL_DIV);
  parser.DefineOprt(
      "/", [](double a, double b) { return a / b; }, mu::prMUL_DIV);
  parser.DefineOprt(
      "^", [](double a, double b) { return std::pow(a, b); }, mu::prPOW, mu::oaRIGHT);
}

/// By how much a number of that dimension grows when base unit k becomes smaller by `factor`.
double growth(const Dimension& dimension, std::size_t k, double factor) {
  return std::pow(factor, dimension.powers[k]);
}

}  // namespace

struct Expression::Parsed {
  struct Literal {
    double value;
    Dimension dimension;
    double now;  ///< what the parser reads
  };
  struct Parameter {
    std::string name;
    Dimension dimension;
    double now;
  };
  mu::Parser parser;
  std::deque<Literal> literals;  // in place: the parser has their addresses
  std::deque<Parameter> parameters;
  std::vector<std::string> names;
  Dimension dimension;
  bool is_zero = true;  ///< whatever its parameters are

  double evaluate() {
    try {
      return parser.Eval();
    } catch (const mu::Parser::exception_type&) {
      return std::nan("");
    }
  }
  /// The value where parameter number n is about 1 in units that are smaller by `factor` in base unit k.
  double sample(int which, std::size_t k, double factor) {
    double next = 0.71 + 0.13 * which;
    for (Parameter& p : parameters) {
      p.now = next * growth(p.dimension, k, factor);
      next = next < 1.3 ? next * 1.37 : next / 1.9;
    }
    for (Literal& l : literals) l.now = l.value * growth(l.dimension, k, factor);
    const double value = evaluate();
    for (Literal& l : literals) l.now = l.value;
    return value;
  }
  /// The power of base unit k; empty where the value is a sum of different things.
  std::optional<int> power(std::size_t k) {
    constexpr int samples = 5;
    std::optional<int> found;
    for (int which = 0; which < samples; ++which) {
      const double before = sample(which, k, 1);
      if (!std::isfinite(before)) continue;
      if (before == 0) {  // also of a comparison that does not hold, which may hold in other units
        for (const double factor : {1e9, 1e-9})
          if (sample(which, k, factor) == 1) return std::nullopt;
        continue;
      }
      is_zero = false;
      // the large ones turn comparisons of different things
      for (const double factor : {3.0, 0.7, 1e9, 1e-9}) {
        const double ratio = sample(which, k, factor) / before;
        const double power = std::log(ratio) / std::log(factor);
        if (!(ratio > 0) || std::abs(power - std::round(power)) > 1e-6) return std::nullopt;
        const int whole = static_cast<int>(std::lround(power));
        if (found && *found != whole) return std::nullopt;
        found = whole;
      }
    }
    return found.value_or(0);
  }
};

std::variant<Expression, ExpressionRefusal> Expression::read(std::string_view text, const Units& units,
                                                             const DimensionOf& dimension_of,
                                                             const std::vector<std::string>& names,
                                                             Comparison comparison) {
  auto parsed = std::make_shared<Parsed>();
  std::string to_parse(text);
  const auto is_parameter = [&](std::string_view name) { return dimension_of(name).has_value(); };
  for (const Token& token : Cutter(text, is_parameter).all()) {
    if (token.kind == Token::Kind::number && !token.unit.empty()) {
      const auto dimension = units.dimension(token.unit);
      if (!dimension)
        return ExpressionRefusal{{"'" + token.unit + "' is not a unit",
                                  "allowed: numbers with a unit such as \"0.2 um\", and parameters"},
                                 token.at};
      const auto conversion = units.conversion(token.unit, dimension->text());
      const auto* to_si = std::get_if<Conversion>(&conversion);
      const auto si =
          to_si && to_si->offset == 0
              ? (*to_si)(text.substr(token.at, token.size - token.unit.size())
                             .substr(0, text.substr(token.at).find_first_not_of("0123456789.eE+-")))
              : std::nullopt;
      if (!si)
        return ExpressionRefusal{{"'" + token.unit + "' cannot be used in an expression",
                                  "allowed: units without a zero point of their own, such as K"},
                                 token.at};
      const std::string name = stand_in(parsed->literals.size(), token.size);
      if (name.size() > token.size)
        return ExpressionRefusal{{"too many numbers with units", "write a space before the units"}, token.at};
      parsed->literals.push_back({*si, *dimension, *si});
      to_parse.replace(token.at, token.size, name);
    } else if (token.kind == Token::Kind::name) {
      const std::string name(text.substr(token.at, token.size));
      if (name == pi_name || std::ranges::find(parsed->names, name) != parsed->names.end()) continue;
      const auto dimension = dimension_of(name);
      if (!dimension) {
        Refusal refusal = unknown_word(name, "parameter", names);
        refusal.wrong = "no such parameter: " + name;
        return ExpressionRefusal{refusal, token.at};
      }
      parsed->names.push_back(name);
      parsed->parameters.push_back({name, *dimension, 1});
    }
  }
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto is = [&](std::size_t k, std::string_view any) {
      return k < text.size() && any.find(text[k]) != any.npos;
    };
    if (text[at] == '=' && !is(at + 1, "=") && !(at > 0 && is(at - 1, "=<>!")))
      return ExpressionRefusal{{"an expression gives nothing a value", "allowed: == for a comparison"}, at};
  }
  mu::Parser& parser = parsed->parser;
  constexpr const char* characters = "0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ@";
  try {
    parser.DefineNameChars(characters);
    if (comparison == Comparison::to_12_digits) compare_to_12_digits(parser);
    parser.DefineConst(std::string(pi_name), 3.14159265358979323846);
    parser.DefineFun("pow", [](double base, double power) { return std::pow(base, power); });
    for (std::size_t k = 0; k < parsed->literals.size(); ++k) {
      std::string name = stand_in(k, 0);
      parser.DefineVar(name, &parsed->literals[k].now);
    }
    for (Parsed::Parameter& p : parsed->parameters) parser.DefineVar(p.name, &p.now);
    parser.SetExpr(to_parse);
    int values = 0;
    parser.Eval(values);
    if (values != 1)
      return ExpressionRefusal{
          {"more than one value", "allowed: commas between arguments of a function only"}, text.find(',')};
  } catch (const mu::Parser::exception_type& error) {
    const auto at = static_cast<std::size_t>(std::max(error.GetPos(), 0));
    return ExpressionRefusal{{"not an expression: " + error.GetMsg(),
                              "allowed: + - * / ^ ( ), numbers with units, parameters, " + listed(functions)},
                             std::min(at, text.size())};
  }
  for (std::size_t k = 0; k < Dimension::units.size(); ++k) {
    const auto power = parsed->power(k);
    if (!power)
      return ExpressionRefusal{
          {"adds or compares quantities of different units", "allowed: terms that all have the same unit"},
          0};
    parsed->dimension.powers[k] = *power;
  }
  return Expression(std::move(parsed));
}

const std::vector<std::string>& Expression::names() const { return parsed_->names; }
const Dimension& Expression::dimension() const { return parsed_->dimension; }
bool Expression::has(const Dimension& dimension) const {
  return parsed_->is_zero || parsed_->dimension == dimension;
}

double Expression::value(const std::function<double(const std::string& name)>& of) const {
  for (Parsed::Parameter& p : parsed_->parameters) p.now = of(p.name);
  return parsed_->evaluate();
}

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  const auto no_parameter = [](std::string_view) { return false; };
  for (const Token& token : Cutter(text, no_parameter).all())
    if (token.kind == Token::Kind::name) names.emplace_back(text.substr(token.at, token.size));
  return names;
}

}  // namespace mpmstudy
