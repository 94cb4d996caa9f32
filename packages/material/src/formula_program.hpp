#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "toile/material/law.hpp"

// A formula as a short list of instructions on numbered slots. What depends on parameters alone is computed in slots of
// type P, once for all points that share them; the rest in slots of type T.
namespace toile::material::formula {

enum class Op { copy, negate, add, subtract, multiply, divide, power, log, exp, sqrt, sin, cos, select };

/// An operand or a result.
struct Slot {
  bool field = false;  ///< depends on C: a T; else a P
  int index = 0;
};

/// result = op(a, b); select: where(a < b, c, d).
struct Instruction {
  Op op;
  Slot result, a, b, c, d;
};

enum class Variable { C11, C22, C12, C33, I1, I2, J, l1, l2, E11, E22, E12 };

/// Name of each Variable, in their order, with its meaning for the input reference.
struct VariableInfo {
  const char* name;
  const char* text;
};
const std::vector<VariableInfo>& variables();

struct Program {
  int n_params = 0;
  std::vector<double> numbers;  ///< P slots: parameters, numbers, then results
  std::vector<Variable> used;   ///< T slots: these variables, then results
  std::vector<Instruction> uniform, field;
  int uniform_slots = 0, field_slots = 0;
  Slot energy;
};

/// What is wrong with a formula, and where (0: its first character).
struct Problem : std::runtime_error {
  Problem(std::size_t at, const std::string& what) : std::runtime_error(what), position(at) {}
  std::size_t position;
};

/// Throws Problem if the formula is so long or nested so deep that parsing it would take the whole stack.
void check_nesting(const std::string& text);

/// Translates `text`, whose names are variables(), functions, `parameters` and its own definitions. Throws Problem.
Program translate(const std::string& text, const std::vector<std::string>& parameters);

template <class T>
T value_of(Variable variable, const PlaneC<T>& c) {
  switch (variable) {
    case Variable::C11:
      return c.C11;
    case Variable::C22:
      return c.C22;
    case Variable::C12:
      return c.C12;
    case Variable::C33:
      return c.C33;
    case Variable::I1:
      return c.C11 + c.C22 + c.C33;
    case Variable::I2:
      return c.cof11() + c.cof22() + c.cof33();
    case Variable::J:
      return sqrt(c.det);
    case Variable::l1:
      return sqrt(c.C11);
    case Variable::l2:
      return sqrt(c.C22);
    case Variable::E11:
      return 0.5 * (c.C11 - 1.0);
    case Variable::E22:
      return 0.5 * (c.C22 - 1.0);
    default:
      return 0.5 * c.C12;
  }
}

/// r = op(a, b) for the arithmetic of two values, at least one of which has the type of r.
template <class R, class A, class B>
void arithmetic(Op op, R& r, const A& a, const B& b) {
  switch (op) {
    case Op::add:
      r = a + b;
      return;
    case Op::subtract:
      r = a - b;
      return;
    case Op::multiply:
      r = a * b;
      return;
    default:
      r = a / b;
      return;
  }
}

/// r = op(a) for the functions of one value.
template <class R>
void function(Op op, R& r, const R& a) {
  switch (op) {
    case Op::negate:
      r = -a;
      return;
    case Op::log:
      r = log(a);
      return;
    case Op::exp:
      r = exp(a);
      return;
    case Op::sqrt:
      r = sqrt(a);
      return;
    case Op::sin:
      r = sin(a);
      return;
    case Op::cos:
      r = cos(a);
      return;
    default:
      r = a;
      return;
  }
}

/// The instructions without C. p [uniform_slots]: the first n_params are given, the others are filled.
template <class P>
void run_uniform(const Program& program, P* p) {
  for (std::size_t k = 0; k < program.numbers.size(); ++k) p[program.n_params + k] = P(program.numbers[k]);
  for (const Instruction& i : program.uniform) {
    P& r = p[i.result.index];
    const P &a = p[i.a.index], &b = p[i.b.index];
    if (i.op == Op::select) {
      r = where(less(a, b), p[i.c.index], p[i.d.index]);
    } else if (i.op == Op::power) {
      r = power(a, b);
    } else if (i.op >= Op::add && i.op <= Op::divide) {
      arithmetic(i.op, r, a, b);
    } else {
      function(i.op, r, a);
    }
  }
}

/// The energy at c. p [uniform_slots] from run_uniform(); t [field_slots] is scratch.
template <class T, class P>
T run_field(const Program& program, const PlaneC<T>& c, const P* p, T* t) {
  for (std::size_t k = 0; k < program.used.size(); ++k) t[k] = value_of(program.used[k], c);
  for (const Instruction& i : program.field) {
    T& r = t[i.result.index];
    if (i.op == Op::select) {
      r = where(less(t[i.a.index], t[i.b.index]), t[i.c.index], t[i.d.index]);
    } else if (i.op == Op::power) {
      r = power(t[i.a.index], p[i.b.index]);
    } else if (i.op >= Op::add && i.op <= Op::divide) {
      if (!i.b.field) {
        arithmetic(i.op, r, t[i.a.index], p[i.b.index]);
      } else if (!i.a.field) {
        arithmetic(i.op, r, p[i.a.index], t[i.b.index]);
      } else {
        arithmetic(i.op, r, t[i.a.index], t[i.b.index]);
      }
    } else if (i.a.field) {
      function(i.op, r, t[i.a.index]);
    } else {
      r = p[i.a.index];  // copy: a value without C where one with C is needed
    }
  }
  return t[program.energy.index];
}

}  // namespace toile::material::formula
