package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;

/** Command {@code pendant robots [NAME]}: the arms there are, and what is known of one. */
final class RobotsCommand implements Subcommand {
  private static final Option MARKDOWN = Option.flag("--markdown").explained("--markdown.robots");

  @Override
  public String name() {
    return "robots";
  }

  @Override
  public String operands() {
    return "[NAME]";
  }

  @Override
  public List<Option> options() {
    return List.of(MARKDOWN);
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    // A display name may have a blank, and few people quote it.
    String name = String.join(" ", arguments.operands());
    if (arguments.has(MARKDOWN)) {
      if (!name.isEmpty()) {
        throw new UsageException(text("unexpectedOnPage", name));
      }
      console.print(new RobotPage(RobotDataSheet.all()).markdown().stripTrailing());
    } else if (arguments.operands().isEmpty()) {
      RobotList.lines(RobotDataSheet.all()).forEach(console::print);
    } else {
      new RobotSheet(RobotDataSheet.load(RobotName.idOf(() -> text("theName"), name)))
          .lines()
          .forEach(console::print);
    }
    return ExitCode.DONE;
  }
}
