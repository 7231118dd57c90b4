package org.pendant.desktop.program.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.UnaryOperator;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.kit.form.Measure;
import org.pendant.kit.text.Messages;
import org.pendant.project.program.Identifiers;
import org.pendant.project.program.NodeField;
import org.pendant.project.program.NumberRange;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Step;

/** Form builder: puts a form together; most edits give another step for the node. */
final class FormBuilder {
  private final FormContext context;
  private final String kind;
  private final String title;
  private final String about;
  private final List<NodeForm.Part> parts = new ArrayList<>();
  private String heading = "";
  private List<Item> items = new ArrayList<>();

  FormBuilder(FormContext context, String kind, String title, String about) {
    this.context = context;
    this.kind = kind;
    this.title = title;
    this.about = about;
  }

  FormContext context() {
    return context;
  }

  /** Begins another part of the form. */
  FormBuilder part(String text) {
    close();
    heading = text;
    return this;
  }

  private void close() {
    if (!items.isEmpty()) {
      parts.add(new NodeForm.Part(heading, items));
      items = new ArrayList<>();
    }
  }

  NodeForm build() {
    close();
    return new NodeForm(kind, title, about, parts);
  }

  FormBuilder add(Item item) {
    items.add(item);
    return this;
  }

  /** A number that there must be. */
  FormBuilder number(NodeField field, String label, double value, DoubleFunction<Step> step) {
    return number(field, label, value, field.range(), step);
  }

  /**
   * A number that there must be.
   *
   * @param usual what this arm or signal has of the field's range
   */
  FormBuilder number(
      NodeField field, String label, double value, NumberRange usual, DoubleFunction<Step> step) {
    return add(numberOf(field, label, value, usual, step));
  }

  /** As {@link #number}, for a line or a grid. */
  Item.Quantity numberOf(NodeField field, String label, double value, DoubleFunction<Step> step) {
    return numberOf(field, label, value, field.range(), step);
  }

  private Item.Quantity numberOf(
      NodeField field, String label, double value, NumberRange usual, DoubleFunction<Step> step) {
    return new Item.Quantity(
        field,
        label,
        OptionalDouble.of(value),
        usual,
        "",
        measure(field),
        typed -> context.with(step.apply(typed.orElse(value))));
  }

  private Measure measure(NodeField field) {
    return ShownMeasure.of(Item.Quantity.measureOf(field), context.host().poseForm());
  }

  /** A number that there may be. */
  FormBuilder optional(
      NodeField field,
      String label,
      OptionalDouble value,
      String whenEmpty,
      Function<OptionalDouble, Step> step) {
    return add(
        new Item.Quantity(
            field,
            label,
            value,
            field.range(),
            whenEmpty,
            measure(field),
            typed -> context.with(step.apply(typed))));
  }

  FormBuilder count(NodeField field, String label, int value, IntFunction<Step> step) {
    return number(field, label, value, typed -> step.apply((int) Math.rint(typed)));
  }

  /** A line of text that may be anything. */
  FormBuilder text(
      String name, String label, String value, String hint, Function<String, Step> step) {
    return add(
        new Item.Text(
            name,
            label,
            value,
            hint,
            List.of(),
            text -> "",
            each -> context.with(step.apply(each))));
  }

  /** A name of the language for a variable. */
  FormBuilder variable(
      String name, String label, String value, List<String> known, Function<String, Step> step) {
    return add(variableOf(name, label, value, known, step));
  }

  Item.Text variableOf(
      String name, String label, String value, List<String> known, Function<String, Step> step) {
    return new Item.Text(
        name,
        label,
        value,
        FormTexts.text("aNameSuchAsCount"),
        known,
        FormBuilder::nameRefusal,
        each -> context.with(step.apply(each.strip())));
  }

  /** Why a text cannot be the name of a variable; empty if it can, or is empty. */
  static String nameRefusal(String text) {
    String name = text.strip();
    return name.isEmpty() ? "" : Identifiers.refusal(name).map(Messages::shown).orElse("");
  }

  /** An expression for any value. */
  FormBuilder expression(
      String name, String label, String value, String hint, Function<String, Step> step) {
    return add(expressionOf(name, label, value, hint, step));
  }

  Item.Expression expressionOf(
      String name, String label, String value, String hint, Function<String, Step> step) {
    return new Item.Expression(
        name, label, value, hint, false, each -> context.with(step.apply(each.strip())));
  }

  /** An expression that is true or false. */
  FormBuilder condition(
      String name, String label, String value, String hint, Function<String, Step> step) {
    return add(
        new Item.Expression(
            name, label, value, hint, true, each -> context.with(step.apply(each.strip()))));
  }

  FormBuilder check(String name, String label, boolean value, Function<Boolean, Step> step) {
    return add(new Item.Check(name, label, value, each -> context.with(step.apply(each))));
  }

  /** A choice that folds out. */
  FormBuilder choice(
      String name,
      String label,
      List<Option> options,
      String value,
      String missing,
      Function<String, Step> step) {
    return add(
        new Item.Choice(
            name, label, options, value, false, missing, each -> context.with(step.apply(each))));
  }

  /** A choice of few, side by side. */
  FormBuilder sides(
      String name, String label, List<Option> options, String value, Function<String, Step> step) {
    return add(
        new Item.Choice(
            name, label, options, value, true, "", each -> context.with(step.apply(each))));
  }

  /** A choice between two. */
  FormBuilder either(
      String name,
      String label,
      String yes,
      String no,
      boolean value,
      Function<Boolean, Step> step) {
    return sides(
        name,
        label,
        List.of(new Option("true", yes), new Option("false", no)),
        Boolean.toString(value),
        each -> step.apply(Boolean.valueOf(each)));
  }

  /** A choice of the values of an enum. */
  <E extends Enum<E>> FormBuilder oneOf(
      String name, String label, E value, Function<E, String> words, Function<E, Step> step) {
    Class<E> type = value.getDeclaringClass();
    List<Option> options = new ArrayList<>();
    for (E each : type.getEnumConstants()) {
      options.add(new Option(each.name(), words.apply(each)));
    }
    return sides(name, label, options, value.name(), each -> step.apply(Enum.valueOf(type, each)));
  }

  FormBuilder note(String name, Item.Tone tone, String text) {
    return text.isEmpty() ? this : add(new Item.Note(name, tone, text));
  }

  FormBuilder quiet(String name, String text) {
    return note(name, Item.Tone.QUIET, text);
  }

  FormBuilder presses(String name, String label, Item.Press... buttons) {
    return add(new Item.Presses(name, label, List.of(buttons)));
  }

  /** A button that is pressed once. */
  static Item.Press press(String name, String text, String tip, boolean enabled, Runnable press) {
    return new Item.Press(name, text, tip, enabled, press, Optional.empty());
  }

  /** A button that makes another program. */
  Item.Press edit(String name, String text, String tip, UnaryOperator<ProgramTree> next) {
    return press(
        name, text, tip, true, () -> context.change(text, next.apply(context.host().tree())));
  }

  FormBuilder drawing(String name, Sketch sketch, String words) {
    return add(new Item.Drawing(name, sketch, words));
  }
}
