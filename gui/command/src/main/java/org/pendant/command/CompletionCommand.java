package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.function.Supplier;

/**
 * Command {@code pendant completion SHELL}: prints the script by which a shell completes command
 * lines.
 */
final class CompletionCommand implements Subcommand {
  private final Supplier<List<Subcommand>> subcommands;

  /**
   * The command.
   *
   * @param subcommands all that the shell should know, this one included
   */
  CompletionCommand(Supplier<List<Subcommand>> subcommands) {
    this.subcommands = subcommands;
  }

  @Override
  public String name() {
    return "completion";
  }

  @Override
  public String operands() {
    return "bash|zsh|fish";
  }

  @Override
  public List<Option> options() {
    return List.of();
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    CompletionScript script = new CompletionScript(subcommands.get());
    List<String> lines =
        switch (String.join(" ", arguments.operands())) {
          case "bash" -> script.bash();
          case "zsh" -> script.zsh();
          case "fish" -> script.fish();
          case "" -> throw new UsageException(text("noShell"));
          case String other -> throw new UsageException(text("unknownShell", other));
        };
    lines.forEach(console::print);
    return ExitCode.DONE;
  }
}
