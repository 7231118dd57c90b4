package org.pendant.command;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.text.Texts;

/** Completion of command lines for shells, from the options that the subcommands declare. */
final class CompletionScript {
  private final List<Subcommand> subcommands;
  private final Texts usage = UsageTexts.english();

  CompletionScript(List<Subcommand> subcommands) {
    this.subcommands = List.copyOf(subcommands);
  }

  private static List<Option> options(Subcommand subcommand) {
    return Stream.concat(subcommand.options().stream(), Stream.of(Subcommand.HELP)).toList();
  }

  private String names() {
    return subcommands.stream().map(Subcommand::name).collect(Collectors.joining(" "));
  }

  /** For {@code source <(pendant completion bash)}. */
  List<String> bash() {
    List<String> lines = new ArrayList<>();
    lines.add("_pendant() {");
    lines.add("  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} options");
    lines.add("  COMPREPLY=()");
    lines.add("  if [ \"$COMP_CWORD\" -eq 1 ]; then");
    lines.add("    COMPREPLY=($(compgen -W \"" + names() + " --help --version\" -- \"$cur\"))");
    lines.add("    return");
    lines.add("  fi");
    lines.add("  case ${COMP_WORDS[1]} in");
    for (Subcommand each : subcommands) {
      lines.add("    " + each.name() + ")");
      lines.add(
          "      options='"
              + options(each).stream().map(Option::name).collect(Collectors.joining(" "))
              + "'");
      lines.add("      case $prev in");
      for (Option option : each.options()) {
        if (option.takesValue()) {
          lines.add("        " + option.name() + ") " + bashValues(option) + " return ;;");
        }
      }
      lines.add("      esac ;;");
    }
    lines.add("    *) return ;;");
    lines.add("  esac");
    lines.add("  case $cur in -*) COMPREPLY=($(compgen -W \"$options\" -- \"$cur\")) ;; esac");
    lines.add("}");
    lines.add("complete -o default -F _pendant pendant");
    return lines;
  }

  /** Without words of its own the shell offers files. */
  private static String bashValues(Option option) {
    List<String> words = option.argument().suggestions();
    return words.isEmpty()
        ? ""
        : "COMPREPLY=($(compgen -W \"" + String.join(" ", words) + "\" -- \"$cur\"));";
  }

  /** For a file {@code _pendant} in a folder of {@code $fpath}. */
  List<String> zsh() {
    List<String> lines = new ArrayList<>();
    lines.add("#compdef pendant");
    lines.add("_pendant() {");
    lines.add("  local -a commands");
    lines.add("  commands=(");
    for (Subcommand each : subcommands) {
      lines.add("    " + quoted(each.name() + ":" + each.summary(usage)));
    }
    lines.add("  )");
    lines.add("  if (( CURRENT == 2 )); then");
    lines.add("    _describe command commands");
    lines.add("    return");
    lines.add("  fi");
    lines.add("  shift words");
    lines.add("  (( CURRENT-- ))");
    lines.add("  case $words[1] in");
    for (Subcommand each : subcommands) {
      lines.add("    " + each.name() + ")");
      lines.add("      _arguments \\");
      options(each).forEach(option -> lines.add("        " + quoted(zshOption(option)) + " \\"));
      lines.add("        '*:file:_files' ;;");
    }
    lines.add("  esac");
    lines.add("}");
    lines.add("_pendant \"$@\"");
    return lines;
  }

  private String zshOption(Option option) {
    String summary = option.summary(usage).replaceAll("([\\[\\]:\\\\])", "\\\\$1");
    if (!option.takesValue()) {
      return option.name() + "[" + summary + "]";
    }
    List<String> words = option.argument().suggestions();
    String others = option.argument() instanceof OptionArgument.Text ? "_files" : " ";
    String values = words.isEmpty() ? others : "(" + String.join(" ", words) + ")";
    String placeholder = option.value().replaceAll("([:\\\\])", "\\\\$1");
    return (option.repeatable() ? "*" : "")
        + option.name()
        + "=["
        + summary
        + "]:"
        + placeholder
        + ":"
        + values;
  }

  /** For {@code pendant completion fish | source}. */
  List<String> fish() {
    List<String> lines = new ArrayList<>();
    for (Subcommand each : subcommands) {
      lines.add(
          "complete -c pendant -n __fish_use_subcommand -a "
              + each.name()
              + " -d "
              + fishQuoted(each.summary(usage)));
    }
    for (Subcommand each : subcommands) {
      for (Option option : options(each)) {
        lines.add(
            "complete -c pendant -n '__fish_seen_subcommand_from "
                + each.name()
                + "' -l "
                + option.name().substring("--".length())
                + fishValues(option)
                + " -d "
                + fishQuoted(option.summary(usage)));
      }
    }
    return lines;
  }

  private static String fishValues(Option option) {
    List<String> words = option.argument().suggestions();
    if (!option.takesValue()) {
      return "";
    }
    return words.isEmpty() ? " -r" : " -x -a " + fishQuoted(String.join(" ", words));
  }

  private static String quoted(String text) {
    return "'" + text.replace("'", "'\\''") + "'";
  }

  private static String fishQuoted(String text) {
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'";
  }
}
