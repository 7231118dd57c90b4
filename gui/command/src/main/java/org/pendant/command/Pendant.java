package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.Optional;
import org.pendant.command.doctor.Doctor;
import org.pendant.command.launch.Relaunch;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.Version;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.check.Nearest;
import org.pendant.testing.builtin.TestBuiltins;
import org.pendant.text.Texts;

/**
 * The {@code pendant} command: finds the subcommand, and turns whatever happens into an exit code
 * (docs/command-line.md).
 */
public final class Pendant {
  static final Option VERSION = Option.flag("--version");

  /**
   * Property of launchers that have given the JVM nothing that waits for its exit, such as an agent
   * that writes what it has seen.
   */
  private static final String END_AT_ONCE = "pendant.end-at-once";

  private final Console console;
  private final DesktopServices services;
  private final List<Subcommand> subcommands;
  private boolean mayEndAtOnce;

  Pendant(Console console) {
    this(console, DesktopServices.ofClassPath());
  }

  Pendant(Console console, DesktopServices services) {
    this.console = console;
    this.services = services;
    subcommands =
        List.of(
            new OpenCommand(services),
            new RunCommand(),
            new CheckCommand(),
            new TestCommand(services),
            new SweepCommand(services),
            new ConvertCommand(),
            new RenderCommand(services),
            new ServeCommand(),
            new RpcCommand(System.in),
            new LspCommand(System.in, new FileOutputStream(FileDescriptor.out)),
            new DapCommand(System.in, new FileOutputStream(FileDescriptor.out)),
            new RecordCommand(),
            new CompareCommand(),
            new FitCommand(),
            new FunctionsCommand(StandardBuiltins::create, TestBuiltins::create),
            new RobotsCommand(),
            new CalibrateCommand(),
            new DoctorCommand(Doctor::ofThisComputer),
            new CompletionCommand(this::subcommands));
  }

  /** Runs the command line {@code words} and ends the process. */
  public static void main(String[] words) {
    Console console = Console.ofProcess();
    CommandLanguage.refusal(System.getenv())
        .ifPresent(
            refusal -> {
              console.complain("pendant: " + refusal);
              System.exit(ExitCode.WRONG_USAGE.number());
            });
    if (System.getProperty(Relaunch.STARTED_AS) != null) {
      relaunch(List.of(words), console);
    }
    Pendant pendant = new Pendant(console);
    ExitCode code = pendant.run(List.of(words));
    if (pendant.mayEndAtOnce && Boolean.getBoolean(END_AT_ONCE)) {
      // At an exit the JDK looks for a logger in every jar: a sixth of what a short run takes.
      Runtime.getRuntime().halt(code.number());
    }
    System.exit(code.number());
  }

  /** Ends the process with another that has run {@code words}, where those need other options. */
  private static void relaunch(List<String> words, Console console) {
    try {
      Relaunch.run(words).ifPresent(System::exit);
    } catch (IOException e) {
      console.complain(text("goesOnWithOptions", e.getMessage()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** All that there are. */
  List<Subcommand> subcommands() {
    return subcommands;
  }

  /** Runs the command line {@code words}; everything is written out when it returns. */
  ExitCode run(List<String> words) {
    ExitCode code;
    try {
      code = choose(words);
    } catch (Throwable fault) {
      // Nothing may pass unseen, an exhausted stack or memory included.
      code = internalError(fault);
    }
    console.flush();
    return code == ExitCode.DONE && console.outputClosed() ? ExitCode.OUTPUT_CLOSED : code;
  }

  private ExitCode choose(List<String> words) {
    String first = words.isEmpty() ? "" : words.getFirst();
    return switch (first) {
      case "" ->
          new DesktopStart(services, console)
              .run(
                  List.of(),
                  Optional.empty(),
                  Optional.empty(),
                  SimulationWishes.NONE,
                  Optional.empty());
      case "--help", "-h", "help" -> {
        usage().forEach(console::print);
        yield ExitCode.DONE;
      }
      case "--version" -> {
        console.print(Version.line());
        yield ExitCode.DONE;
      }
      default ->
          OpenCommand.understands(first) || isFileToOpen(first)
              ? run(new OpenCommand(services), words)
              : subcommand(first, words.subList(1, words.size()));
    };
  }

  /** A command is a command, even where a file has its name. */
  private boolean isFileToOpen(String word) {
    return subcommands.stream().noneMatch(each -> each.name().equals(word))
        && OpenCommand.isFile(word);
  }

  private ExitCode subcommand(String name, List<String> words) {
    Optional<Subcommand> chosen =
        subcommands.stream().filter(s -> s.name().equals(name)).findFirst();
    if (chosen.isPresent()) {
      return run(chosen.get(), words);
    }
    console.complain("pendant: " + unknown(name));
    console.complain(text("helpLists"));
    return ExitCode.WRONG_USAGE;
  }

  private ExitCode run(Subcommand subcommand, List<String> words) {
    if (words.contains(Subcommand.HELP.name()) || words.contains("-h")) {
      usage(subcommand).forEach(console::print);
      return ExitCode.DONE;
    }
    if (!(subcommand instanceof OpenCommand)) {
      CommandLanguage.speak();
    }
    try {
      ExitCode code = subcommand.run(Arguments.parse(subcommand.options(), words), console);
      mayEndAtOnce = subcommand.mayEndAtOnce();
      return code;
    } catch (UsageException e) {
      console.complain("pendant " + subcommand.name() + ": " + e.getMessage());
      console.complain(text("helpExplains", subcommand.name()));
      return ExitCode.WRONG_USAGE;
    }
  }

  private String unknown(String word) {
    if (word.startsWith("-")) {
      return text("unknownOption", word);
    }
    List<String> names = subcommands.stream().map(Subcommand::name).toList();
    String hint = new Nearest().to(word, () -> names).map(n -> text("didYouMean", n)).orElse("");
    return OpenCommand.whyNoFile(word).orElse(text("unknownCommand", word, hint));
  }

  private List<String> usage() {
    Texts texts = UsageTexts.shown();
    UsageText lines = new UsageText();
    lines.add(texts.get("about"));
    lines.add("");
    texts.get("usageOfAll").lines().forEach(lines::add);
    lines.add("");
    for (Subcommand subcommand : subcommands) {
      lines.row(subcommand.name() + " " + subcommand.operands(), subcommand.summary(texts));
    }
    lines.add("");
    lines.row(Subcommand.HELP.usage(), texts.get("helpOfAll"));
    lines.row(VERSION.usage(), VERSION.description(texts));
    return lines.all();
  }

  private static List<String> usage(Subcommand subcommand) {
    Texts texts = UsageTexts.shown();
    UsageText lines = new UsageText();
    lines.add(texts.get("usageOfCommand", subcommand.name(), subcommand.operands()));
    lines.add("");
    lines.add("pendant " + subcommand.name() + ": " + subcommand.summary(texts));
    lines.add("");
    subcommand.options().forEach(option -> lines.row(option.usage(), option.description(texts)));
    lines.row(Subcommand.HELP.usage(), Subcommand.HELP.description(texts));
    return lines.all();
  }

  private ExitCode internalError(Throwable fault) {
    StringWriter details = new StringWriter();
    fault.printStackTrace(new PrintWriter(details, true));
    console.complain(text("internalError", fault));
    console.complain(text("faultInPendant"));
    console.complainInLines(details.toString().stripTrailing());
    return ExitCode.INTERNAL_ERROR;
  }
}
