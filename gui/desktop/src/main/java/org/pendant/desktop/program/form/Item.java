package org.pendant.desktop.program.form;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.pendant.kit.form.Measure;
import org.pendant.project.program.NodeField;
import org.pendant.project.program.NumberRange;
import org.pendant.project.program.ProgramTree;

/**
 * Item: a part of a form, with its current value. Those that can be changed know the program that
 * comes of another value. Names are their own within a form; what is before the first point of one
 * is the component of the step's record that it is about.
 */
sealed interface Item {

  /** Stable name, such as {@code speed} or {@code what.timeS}. */
  String name();

  /** What people read beside it; empty for nothing. */
  String label();

  /**
   * A number.
   *
   * @param field what it is in the program
   * @param value in SI; empty if there is none
   * @param usual what this arm or signal has of the field's range
   * @param whenEmpty what no number means; empty if there must be one
   * @param measure in what it is shown and typed
   */
  record Quantity(
      NodeField field,
      String label,
      OptionalDouble value,
      NumberRange usual,
      String whenEmpty,
      Measure measure,
      Function<OptionalDouble, ProgramTree> edit)
      implements Item {
    @Override
    public String name() {
      return field.name();
    }

    /** In what a field is usually shown. */
    static Measure measureOf(NodeField field) {
      return switch (field.unit()) {
        case MILLIMETRE -> Measure.MILLIMETRE;
        case MILLIMETRE_PER_S -> Measure.MILLIMETRE_PER_S;
        case MILLIMETRE_PER_S2 -> Measure.MILLIMETRE_PER_S2;
        case DEGREE -> Measure.DEGREE;
        case DEGREE_PER_S -> Measure.DEGREE_PER_S;
        case DEGREE_PER_S2 -> Measure.DEGREE_PER_S2;
        case SECOND -> Measure.SECOND;
        case NEWTON -> Measure.NEWTON;
        case NEWTON_METRE -> Measure.NEWTON_METRE;
        case KILOGRAM -> Measure.KILOGRAM;
        case VOLT -> Measure.VOLT;
        case MILLIAMPERE -> Measure.MILLIAMPERE;
        case COUNT -> Measure.COUNT;
        case NUMBER -> Measure.PLAIN;
      };
    }

    /**
     * Reads what was typed. A limit that is typed as it is shown is that limit, whatever its
     * decimals are behind those that are shown.
     *
     * @return the number in SI
     * @throws IllegalArgumentException with a sentence for people if it is none
     */
    double parse(String typed) {
      double number = measure().parse(typed);
      double limit = Math.clamp(number, field.range().min(), field.range().max());
      return measure().text(number).equals(measure().text(limit)) ? limit : number;
    }

    /** Which numbers can be taken. */
    String legal() {
      return measure() == measureOf(field)
          ? field.range().words(field.unit())
          : field.range().words(measure()::text, measure().symbol());
    }

    /** Why a number, in SI, cannot be taken; empty if it can. */
    String refusal(double number) {
      return field.range().contains(number) ? "" : legal();
    }

    /** The text of the value. */
    String text() {
      return value.isPresent() ? measure().text(value.getAsDouble()) : "";
    }
  }

  /**
   * One line of text.
   *
   * @param hint what to type, shown while it is empty
   * @param suggestions texts that can be chosen
   * @param refusal why a text cannot be taken; empty text if it can
   */
  record Text(
      String name,
      String label,
      String value,
      String hint,
      List<String> suggestions,
      UnaryOperator<String> refusal,
      Function<String, ProgramTree> edit)
      implements Item {
    public Text {
      suggestions = List.copyOf(suggestions);
    }
  }

  /**
   * An expression of the language.
   *
   * @param hint what to type, shown while it is empty
   * @param condition whether it has to be true or false
   */
  record Expression(
      String name,
      String label,
      String value,
      String hint,
      boolean condition,
      Function<String, ProgramTree> edit)
      implements Item {}

  /** Several lines for people to read. */
  record Prose(String name, String label, String value, Function<String, ProgramTree> edit)
      implements Item {}

  /**
   * Several lines of a file.
   *
   * @param script whether it is URScript
   * @param edit empty if it can only be read
   */
  record Code(
      String name,
      String label,
      String value,
      boolean script,
      Optional<Function<String, ProgramTree>> edit)
      implements Item {}

  /**
   * One of several.
   *
   * @param value of one of {@code options}, or of none: then it is missing
   * @param side whether the options stand beside each other, otherwise they fold out
   * @param missing what is said when the value is none of the options, after the value itself
   */
  record Choice(
      String name,
      String label,
      List<Option> options,
      String value,
      boolean side,
      String missing,
      Function<String, ProgramTree> edit)
      implements Item {
    public Choice {
      options = List.copyOf(options);
    }

    /** Why the value cannot stay; empty if it can. */
    String problem() {
      boolean known = options.stream().anyMatch(each -> each.value().equals(value));
      return known || value.isEmpty() ? "" : FormTexts.text("quoted", value, missing);
    }
  }

  /** What can be chosen, and how people read it. */
  record Option(String value, String text) {
    /** What keys search for in a combo box, and what screen readers say. */
    @Override
    public String toString() {
      return text;
    }
  }

  /** Yes or no. */
  record Check(String name, String label, boolean value, Function<Boolean, ProgramTree> edit)
      implements Item {}

  /** Buttons beside each other. */
  record Presses(String name, String label, List<Press> buttons) implements Item {
    public Presses {
      buttons = List.copyOf(buttons);
    }
  }

  /**
   * A button.
   *
   * @param tip what it does, also for people who cannot see it
   * @param enabled whether it can be pressed now
   * @param press what happens
   * @param release what happens when it is let go; empty if it need not be held
   */
  record Press(
      String name,
      String text,
      String tip,
      boolean enabled,
      Runnable press,
      Optional<Runnable> release) {}

  /** A sentence. */
  record Note(String name, Tone tone, String text) implements Item {
    @Override
    public String label() {
      return "";
    }
  }

  /** How much a {@link Note} matters. */
  enum Tone {
    QUIET,
    GOOD,
    WARNING
  }

  /**
   * A picture.
   *
   * @param words for people who cannot see it
   */
  record Drawing(String name, Sketch sketch, String words) implements Item {
    @Override
    public String label() {
      return "";
    }
  }

  /**
   * Numbers in columns.
   *
   * @param columns how many are beside each other at most
   */
  record Grid(String name, String label, int columns, List<Quantity> numbers) implements Item {
    public Grid {
      numbers = List.copyOf(numbers);
    }
  }

  /** Several things beside each other. */
  record Line(String name, String label, List<Item> items) implements Item {
    public Line {
      items = List.copyOf(items);
    }
  }
}
