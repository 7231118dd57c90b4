package org.pendant.command;

import java.util.List;
import org.pendant.text.Texts;

/**
 * Option of a subcommand, declared once: parsing, messages, the usage text, the completion of
 * shells and the tables of docs/command-line.md are made from it.
 *
 * @param name with its two dashes, e.g. {@code --speed}
 * @param argument what may follow it
 * @param key by which the usage texts explain it in one line, without the value that it has at
 *     first; its name unless another command has an option of that name
 * @param standard the argument when the option is not given; empty where there is none
 * @param repeatable whether it may be given several times
 * @param role what the command does with the file that the value names
 * @param example an argument for the documentation
 * @param details what the documentation says of it, in Markdown; empty for the summary
 */
record Option(
    String name,
    OptionArgument argument,
    String key,
    String standard,
    boolean repeatable,
    Role role,
    String example,
    String details) {
  /** What a command does with the file that a value names. */
  enum Role {
    /** There is none. */
    NO_FILE,
    /** It is read by {@link SourceFiles}, and thereby safe from being overwritten. */
    READ,
    /** It is written by {@link OutputFile}, which refuses what is read. */
    WRITTEN
  }

  /** An option that may be given once and names no file. */
  static Option of(String name, OptionArgument argument) {
    String example = argument.placeholder();
    return new Option(name, argument, name, "", false, Role.NO_FILE, example, "");
  }

  /** An option that nothing follows. */
  static Option flag(String name) {
    return of(name, new OptionArgument.None());
  }

  /** An option that any text follows. */
  static Option text(String name, String placeholder) {
    return of(name, new OptionArgument.Text(placeholder));
  }

  /** An option that names a file to be read. */
  static Option input(String name, String placeholder) {
    return text(name, placeholder).in(Role.READ);
  }

  /** An option that names a file to be written. */
  static Option output(String name, String placeholder) {
    return text(name, placeholder).in(Role.WRITTEN);
  }

  /** The same, whose value may be the path of a file that the command reads. */
  Option reading() {
    return in(Role.READ);
  }

  private Option in(Role other) {
    return new Option(name, argument, key, standard, repeatable, other, example, details);
  }

  /** The same, explained by another key. */
  Option explained(String other) {
    return new Option(name, argument, other, standard, repeatable, role, example, details);
  }

  /** The same with a value that counts when it is not given. */
  Option standing(String value) {
    return new Option(name, argument, key, value, repeatable, role, example, details);
  }

  /** The same, which may be given several times. */
  Option repeated() {
    return new Option(name, argument, key, standard, true, role, example, details);
  }

  /** The same with what the documentation says of it, and an example of what follows it. */
  Option documented(String sample, String markdown) {
    return new Option(name, argument, key, standard, repeatable, role, sample, markdown);
  }

  /** The same with what the documentation says of it. */
  Option documented(String markdown) {
    return documented(example, markdown);
  }

  /** What follows the name, as the usage text calls it; empty for nothing. */
  String value() {
    return argument.placeholder();
  }

  /** Whether a value follows the name. */
  boolean takesValue() {
    return !value().isEmpty();
  }

  /** The option as the usage text shows it, e.g. {@code --speed max|1|N}. */
  String usage() {
    return takesValue() ? name + " " + value() : name;
  }

  /** One line about it, without the value that it has at first. */
  String summary(Texts usage) {
    return usage.get(key);
  }

  /** The line of the usage text about it. */
  String description(Texts usage) {
    String summary = summary(usage);
    String whole = standard.isEmpty() ? summary : usage.get("default", summary, standard);
    return repeatable ? usage.get("repeatable", whole) : whole;
  }

  /** A row of the documentation's table. */
  List<String> row(Texts usage) {
    String shown = takesValue() ? name + " " + example : name;
    return List.of("`" + shown + "`", details.isEmpty() ? description(usage) : details);
  }
}
