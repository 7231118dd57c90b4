package org.pendant.desktop.whatif;

import static org.pendant.desktop.whatif.WhatIfTexts.text;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.recording.whatif.Variant;
import org.pendant.script.vm.Program;

/**
 * Variant row: a variant as people type it.
 *
 * @param speed of the slider, %; empty for as it was
 * @param load on the flange, kg; empty for as it was
 * @param edited whether the program runs as it is edited now, not as it ran
 */
record VariantRow(String name, String speed, String load, boolean edited) {
  static final VariantRow AS_IT_RAN = new VariantRow(text("asItRanName"), "", "", false);

  private static final int PERCENT = 100;

  /** Drops blanks around what was typed. */
  VariantRow {
    name = name.strip();
    speed = withoutUnit(speed, "%");
    load = withoutUnit(load, "kg");
  }

  VariantRow named(String other) {
    return new VariantRow(other, speed, load, edited);
  }

  VariantRow withSpeed(String other) {
    return new VariantRow(name, other, load, edited);
  }

  VariantRow withLoad(String other) {
    return new VariantRow(name, speed, other, edited);
  }

  VariantRow withEdited(boolean other) {
    return new VariantRow(name, speed, load, other);
  }

  private static String withoutUnit(String typed, String unit) {
    String text = typed.strip();
    return text.toLowerCase(Locale.ROOT).endsWith(unit)
        ? text.substring(0, text.length() - unit.length()).strip()
        : text;
  }

  /** Why a text is no name; empty if it is one. */
  static String nameRefusal(String typed) {
    return typed.isBlank() ? text("theNameIsEmptyMustSay") : "";
  }

  /** Why a text is no speed; empty if it is one. */
  static String speedRefusal(String typed) {
    return refusal(text("speed"), withoutUnit(typed, "%"), 1, PERCENT, "%");
  }

  /** Why a text is no load; empty if it is one. */
  static String loadRefusal(String typed) {
    return refusal(text("load"), withoutUnit(typed, "kg"), 0, Variant.MAX_LOAD_KG, "kg");
  }

  private static String refusal(String what, String typed, double least, double most, String unit) {
    if (typed.isEmpty()) {
      return "";
    }
    OptionalDouble number = number(typed);
    boolean fits =
        number.isPresent() && number.getAsDouble() >= least && number.getAsDouble() <= most;
    return fits
        ? ""
        : String.format(Locale.ROOT, text("isMustBeToOrEmpty"), what, typed, least, most, unit);
  }

  private static OptionalDouble number(String typed) {
    try {
      return typed.isEmpty()
          ? OptionalDouble.empty()
          : OptionalDouble.of(Double.parseDouble(typed));
    } catch (NumberFormatException _) {
      return OptionalDouble.empty();
    }
  }

  /**
   * What it means.
   *
   * @param program as it is edited now; only looked at by a row that wants it
   */
  Variant variant(Optional<Program> program) {
    OptionalDouble percent = number(speed);
    return new Variant(
        name,
        percent.isPresent()
            ? OptionalDouble.of(percent.getAsDouble() / PERCENT)
            : OptionalDouble.empty(),
        number(load),
        program.filter(each -> edited));
  }
}
