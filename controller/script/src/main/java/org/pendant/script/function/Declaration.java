package org.pendant.script.function;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.Value;

/** Declaration of one built-in function, built up in a chain that {@link #does} closes. */
public final class Declaration<H extends Host> {
  private final Builtins<H> owner;
  private final Optional<Type> receiver;
  private final String name;
  private final List<Parameter> parameters = new ArrayList<>();
  private final List<Optional<Value>> defaults = new ArrayList<>();
  private String module = "";
  private String section = "";
  private String documentation = "";
  private String deprecated = "";
  private Type result = Type.NONE;
  private Unit resultUnit = Unit.NONE;
  private Effect effect = Effect.CHANGES;
  private OptionalInt costNs = OptionalInt.empty();
  private boolean changesReceiver;
  private boolean physicalTime;
  private boolean allowedInSecondary = true;

  Declaration(Builtins<H> owner, Optional<Type> receiver, String name) {
    this.owner = owner;
    this.receiver = receiver;
    this.name = name;
  }

  /** The manual's module and section, e.g. {@code manual("internals", "16.54")}. */
  public Declaration<H> manual(String module, String section) {
    this.module = module;
    this.section = section;
    return this;
  }

  /** What it does, in our own words; the first sentence stands alone in completion lists. */
  public Declaration<H> doc(String text) {
    documentation = text;
    return this;
  }

  /** A required parameter. */
  public Declaration<H> needs(String parameter, Type type) {
    return add(new Parameter(parameter, type, Unit.NONE, true, ""), Optional.empty());
  }

  /** A required number with a unit. */
  public Declaration<H> needs(String parameter, Unit unit) {
    return add(new Parameter(parameter, Type.NUMBER, unit, true, ""), Optional.empty());
  }

  /** An optional parameter with a default value. */
  public Declaration<H> takes(String parameter, Type type, Value defaultValue) {
    return add(
        new Parameter(parameter, type, Unit.NONE, false, written(defaultValue)),
        Optional.of(defaultValue));
  }

  /** An optional number with a unit and a default. */
  public Declaration<H> takes(String parameter, Unit unit, double defaultValue) {
    Value value = Value.of(defaultValue);
    return add(
        new Parameter(parameter, Type.NUMBER, unit, false, written(value)), Optional.of(value));
  }

  /** An optional parameter whose absence the code notices itself, see {@link Call#given}. */
  public Declaration<H> mayTake(String parameter, Type type, Unit unit, String defaultDescription) {
    return add(
        new Parameter(parameter, type, unit, false, "<" + defaultDescription + ">"),
        Optional.empty());
  }

  /** Another name for the parameter that was declared last. */
  public Declaration<H> alias(String other) {
    Parameter last = parameters.removeLast();
    parameters.add(
        new Parameter(
            last.name(),
            last.type(),
            last.unit(),
            last.required(),
            last.defaultText(),
            List.of(other)));
    return this;
  }

  public Declaration<H> returns(Type type) {
    result = type;
    return this;
  }

  public Declaration<H> returns(Unit unit) {
    result = Type.NUMBER;
    resultUnit = unit;
    return this;
  }

  /** It may take robot time: a secondary program refuses it (manual 12.1). */
  public Declaration<H> physicalTime() {
    physicalTime = true;
    allowedInSecondary = false;
    return this;
  }

  /** What it does beyond its answer; unless said it {@link Effect#CHANGES}. */
  public Declaration<H> effect(Effect what) {
    effect = what;
    return this;
  }

  /**
   * Takes more computing time than the usual builtin.
   *
   * @param ns of each call, on a usual computer, roughly
   */
  public Declaration<H> costs(int ns) {
    costNs = OptionalInt.of(ns);
    return this;
  }

  /** A method that changes the object that it is called for. */
  public Declaration<H> changesReceiver() {
    changesReceiver = true;
    return this;
  }

  public Declaration<H> notInSecondary() {
    allowedInSecondary = false;
    return this;
  }

  /** Still there for old programs; {@code instead} is what new ones call. */
  public Declaration<H> deprecated(String instead) {
    deprecated = instead;
    return this;
  }

  /** Closes the declaration and enters it into the catalogue. */
  public void does(BuiltinCode<H> code) {
    if (documentation.isBlank() || module.isBlank() || section.isBlank()) {
      throw new IllegalStateException(name + " has no documentation, module or section");
    }
    owner.add(undeclared(code));
  }

  /** What was built up, without an entry in the catalogue. */
  Builtin<H> undeclared(BuiltinCode<H> code) {
    return new Builtin<>(
        new Signature(
            module,
            receiver,
            name,
            parameters,
            result,
            resultUnit,
            section,
            physicalTime,
            allowedInSecondary,
            deprecated,
            documentation),
        defaults,
        effect,
        costNs.orElse(usualNs(effect)),
        changesReceiver,
        code);
  }

  /** What a builtin takes beside its call that does not say so itself. */
  private static int usualNs(Effect effect) {
    return switch (effect) {
      case COMPUTES -> 20;
      case ASKS -> 100;
      case ASKS_GOAL, TELLS -> 1000;
      case CHANGES, SETS, SENSES -> 500;
      case MOVES -> 3000;
    };
  }

  private Declaration<H> add(Parameter parameter, Optional<Value> defaultValue) {
    if (parameter.required() && !parameters.isEmpty() && !parameters.getLast().required()) {
      throw new IllegalStateException(
          name + ": required parameter " + parameter.name() + " follows an optional one");
    }
    parameters.add(parameter);
    defaults.add(defaultValue);
    return this;
  }

  private static String written(Value value) {
    return switch (value) {
      case StringValue text -> '"' + text.bytes() + '"';
      // the text for scripts has six decimals; a tolerance needs more
      case FloatValue small when Double.parseDouble(small.text()) != small.value() ->
          Double.toString(small.value()).replace(".0E", "e");
      default -> value.text();
    };
  }
}
