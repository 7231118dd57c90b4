package org.pendant.project.program.text;

import java.util.List;
import java.util.OptionalDouble;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.Section.InitialValue;
import org.pendant.project.program.Step;

/** Step writer: writes one step: its line, and the lines of text that belong to it. */
final class TextStepWriter {
  private final StringBuilder out;

  TextStepWriter(StringBuilder out) {
    this.out = out;
  }

  /** Appends the word and the fields, without a line end. */
  void line(Step step) {
    out.append(Forms.word(step.getClass()));
    fields((Record) step);
  }

  private void fields(Record of) {
    for (Forms.Field each : Forms.fields(of.getClass())) {
      if (!each.block()) {
        field(each.key(), Components.get(of, each.component()));
      }
    }
  }

  /** What is empty, false or the usual variant is left out. */
  void field(String key, Object value) {
    switch (value) {
      case Double number -> put(key).append(number(number));
      case Integer number -> put(key).append(number);
      case Boolean yes -> {
        if (yes) {
          put(key).append("true");
        }
      }
      case String text -> {
        if (!text.isEmpty()) {
          put(key).append(LineText.quoted(text));
        }
      }
      case OptionalDouble number -> number.ifPresent(present -> put(key).append(number(present)));
      case Enum<?> constant -> put(key).append(Forms.word(constant));
      case Pose pose -> numbers(put(key), pose.toArray());
      case Joints joints -> numbers(put(key), joints.toArray());
      case List<?> items -> {
        if (!items.isEmpty()) {
          put(key).append('[');
          for (int i = 0; i < items.size(); i++) {
            out.append(i == 0 ? "" : ", ").append(item(items.get(i)));
          }
          out.append(']');
        }
      }
      case Record variant -> {
        if (!Components.usual(variant)) {
          put(key).append(Forms.word(variant.getClass()));
          fields(variant);
        }
      }
      default -> throw new IllegalArgumentException(key + " is a " + value.getClass());
    }
  }

  private StringBuilder put(String key) {
    return out.append(' ').append(key).append('=');
  }

  private static void numbers(StringBuilder out, double[] values) {
    for (int i = 0; i < values.length; i++) {
      out.append(i == 0 ? "[" : ", ").append(number(values[i]));
    }
    out.append(']');
  }

  private static String item(Object value) {
    return switch (value) {
      case String text -> LineText.quoted(text);
      case Double number -> number(number);
      default -> value.toString();
    };
  }

  /** Whole numbers without a point, as people write them. */
  private static String number(double value) {
    long whole = (long) value;
    boolean minusZero = value == 0 && 1 / value < 0;
    return whole == value && !minusZero && Math.abs(value) < 1e15
        ? Long.toString(whole)
        : Double.toString(value);
  }

  /** Appends the lines below the line of the node, each with {@code indent} before it. */
  void blocks(Step step, String indent) {
    for (Forms.Field field : Forms.fields(step.getClass())) {
      if (field.block()) {
        for (Object each : (List<?>) Components.get((Record) step, field.component())) {
          out.append(indent).append(Forms.mark(field.component()));
          blockLine(each);
          out.append('\n');
        }
      }
    }
  }

  private void blockLine(Object value) {
    switch (value) {
      case InitialValue row -> {
        out.append(" initial");
        fields(row);
      }
      case String text -> {
        if (text.chars().allMatch(c -> LineText.plain((char) c))
            && text.equals(text.stripTrailing())) {
          out.append(text.isEmpty() ? "" : " ").append(text);
        } else {
          // what would not survive as it stands
          out.append(LineText.quoted(text));
        }
      }
      default -> throw new IllegalArgumentException("a row is a " + value.getClass());
    }
  }
}
