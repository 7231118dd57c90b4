package org.pendant.command;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.pendant.command.service.PortWishes;
import org.pendant.language.check.Nearest;

/**
 * Arguments: the words after a subcommand, sorted into options and operands. Understands {@code
 * --name value}, {@code --name=value}, and {@code --} before operands that begin with a dash.
 */
final class Arguments {
  private final Map<String, List<String>> values = new HashMap<>();
  private final List<String> operands = new ArrayList<>();
  private final SourceFiles files = new SourceFiles();

  private Arguments() {}

  /**
   * @param options what the subcommand understands
   * @throws UsageException for an unknown option, a missing value, or one that is not wanted
   */
  static Arguments parse(List<Option> options, List<String> words) throws UsageException {
    Arguments arguments = new Arguments();
    for (int i = 0; i < words.size(); i++) {
      String word = words.get(i);
      if (word.equals("--")) {
        arguments.operands.addAll(words.subList(i + 1, words.size()));
        break;
      }
      if (!word.startsWith("-") || word.equals("-")) {
        arguments.operands.add(word);
        continue;
      }
      int equals = word.indexOf('=');
      String name = equals < 0 ? word : word.substring(0, equals);
      Option option = find(options, name);
      String value = "";
      if (option.takesValue() && equals >= 0) {
        value = word.substring(equals + 1);
      } else if (option.takesValue()) {
        i++;
        if (i == words.size()) {
          throw new UsageException(CommandTexts.text("needsAValue", name, option.usage()));
        }
        value = words.get(i);
      } else if (equals >= 0) {
        throw new UsageException(CommandTexts.text("takesNoValue", name, word));
      }
      arguments.values.computeIfAbsent(name, key -> new ArrayList<>()).add(value);
    }
    return arguments;
  }

  private static Option find(List<Option> options, String name) throws UsageException {
    for (Option option : options) {
      if (option.name().equals(name)) {
        return option;
      }
    }
    List<String> names = options.stream().map(Option::name).toList();
    String hint =
        new Nearest()
            .to(name, () -> names)
            .map(near -> CommandTexts.text("didYouMean", near))
            .orElse("");
    throw new UsageException(CommandTexts.text("unknownOptionNear", name, hint));
  }

  /** Whether {@code option} was given. */
  boolean has(Option option) {
    return values.containsKey(option.name());
  }

  /** The value of {@code option}, empty when it was not given. */
  Optional<String> value(Option option) throws UsageException {
    List<String> given = values(option);
    if (given.size() > 1) {
      throw new UsageException(CommandTexts.text("givenSeveralTimes", option.name(), given.size()));
    }
    return given.stream().findFirst();
  }

  /** The value of {@code option}, or the one that it has when it is not given. */
  String text(Option option) throws UsageException {
    return value(option).orElse(option.standard());
  }

  /**
   * The word of an option whose argument is an {@link OptionArgument.Choice}; empty when it is not
   * given and has none then.
   *
   * @throws UsageException if it is none of the choice
   */
  Optional<String> word(Option option) throws UsageException {
    OptionArgument.Choice choice = argument(option, OptionArgument.Choice.class);
    Optional<String> word = given(option);
    if (word.isPresent() && !choice.words().contains(word.get())) {
      throw wrong(option, word.get(), choice.legal());
    }
    return word;
  }

  /**
   * The number of an option whose argument is an {@link OptionArgument.Whole}; empty when it is not
   * given and has none then.
   *
   * @throws UsageException if it is outside the range
   */
  OptionalInt whole(Option option) throws UsageException {
    OptionArgument.Whole range = argument(option, OptionArgument.Whole.class);
    Optional<String> text = given(option);
    if (text.isEmpty()) {
      return OptionalInt.empty();
    }
    OptionalInt number = PortWishes.number(text.get(), range.min(), range.max());
    if (number.isEmpty()) {
      throw wrong(option, text.get(), range.legal());
    }
    return number;
  }

  /**
   * The number of an option whose argument is an {@link OptionArgument.Real}; empty when it is not
   * given and has none then.
   *
   * @throws UsageException if it is outside the range
   */
  OptionalDouble number(Option option) throws UsageException {
    OptionArgument.Real range = argument(option, OptionArgument.Real.class);
    Optional<String> text = given(option);
    if (text.isEmpty()) {
      return OptionalDouble.empty();
    }
    OptionalDouble number = parsed(text.get());
    if (number.isEmpty() || !range.contains(number.getAsDouble())) {
      throw wrong(option, text.get(), range.legal());
    }
    return number;
  }

  private Optional<String> given(Option option) throws UsageException {
    return value(option)
        .or(() -> Optional.of(option.standard()).filter(standard -> !standard.isEmpty()));
  }

  private static <A extends OptionArgument> A argument(Option option, Class<A> type) {
    if (!type.isInstance(option.argument())) {
      throw new IllegalArgumentException(
          option.name() + " has " + option.argument() + ", expected " + type.getSimpleName());
    }
    return type.cast(option.argument());
  }

  /** The number that a text is; empty if it is none. */
  static OptionalDouble parsed(String text) {
    try {
      return OptionalDouble.of(Double.parseDouble(text));
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }

  private static UsageException wrong(Option option, String text, String legal) {
    return new UsageException(CommandTexts.text("mustBe", option.name(), text, legal));
  }

  /** All values of an option that may be repeated, in their order. */
  List<String> values(Option option) {
    return values.getOrDefault(option.name(), List.of());
  }

  /** By which everything is read that they name. */
  SourceFiles files() {
    return files;
  }

  /** The words that are no options. */
  List<String> operands() {
    return List.copyOf(operands);
  }
}
