package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;

/** Argument of an option: what may follow its name. */
sealed interface OptionArgument {

  /** What the usage text calls it; empty for an option that nothing follows. */
  String placeholder();

  /** Values that there are, or some of them, for the completion of shells. */
  default List<String> suggestions() {
    return List.of();
  }

  /** Nothing: the option alone says it. */
  record None() implements OptionArgument {
    @Override
    public String placeholder() {
      return "";
    }
  }

  /** Any text that the option itself reads. */
  record Text(String placeholder, List<String> suggestions) implements OptionArgument {
    public Text {
      suggestions = List.copyOf(suggestions);
    }

    Text(String placeholder) {
      this(placeholder, List.of());
    }
  }

  /** One of several words. */
  record Choice(List<String> words) implements OptionArgument {
    public Choice {
      words = List.copyOf(words);
    }

    Choice(String... words) {
      this(List.of(words));
    }

    @Override
    public String placeholder() {
      return String.join("|", words);
    }

    @Override
    public List<String> suggestions() {
      return words;
    }

    /** What is right, such as {@code light or dark}. */
    String legal() {
      return words.size() == 2
          ? text("either", words.getFirst(), words.getLast())
          : text("oneOf", String.join(", ", words));
    }
  }

  /**
   * A whole number from {@code min} to {@code max}.
   *
   * @param min the smallest
   * @param max the largest
   */
  record Whole(String placeholder, int min, int max) implements OptionArgument {
    /** What is right, such as {@code a number from 1 to 100}. */
    String legal() {
      return text("wholeNumber", min, max);
    }
  }

  /**
   * A number.
   *
   * @param min the smallest
   * @param max the largest; the largest there is, or infinity, for none
   * @param open whether {@code min} itself is wrong
   * @param unit in whole words, such as {@code seconds}
   */
  record Real(String placeholder, double min, double max, boolean open, String unit)
      implements OptionArgument {
    private static final int DIGITS = 6;

    /** Whether a number is right. */
    boolean contains(double value) {
      return (open ? value > min : value >= min) && value <= max;
    }

    /** What is right, such as {@code 0 to 60 seconds}. */
    String legal() {
      String least = Decimal.text(min, DIGITS);
      if (max >= Double.MAX_VALUE) {
        return text(open ? "above" : "atLeast", least, unitText());
      }
      String most = Decimal.text(max, DIGITS);
      return text(open ? "aboveAndAtMost" : "fromTo", least, most, unitText());
    }

    /** Symbols of units are the same in all languages. */
    private String unitText() {
      return unit.equals("seconds") ? text("seconds") : unit;
    }
  }
}
