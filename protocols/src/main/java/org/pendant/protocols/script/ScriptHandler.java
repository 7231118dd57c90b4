package org.pendant.protocols.script;

import static org.pendant.protocols.script.ReceivedScriptTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.Deadline;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.Question;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.Session;
import org.pendant.protocols.server.ServerContext;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/**
 * Script handler: runs the scripts that clients send. The scripts of one client run one after the
 * other, each at least a frame before the next; clients do not wait for each other. Any thread.
 */
public final class ScriptHandler {
  /** What a statement without a function around it is called. */
  static final String UNNAMED = "unnamed";

  private static final String FREEDRIVE_NAME = "set_robotmode_freedrive";
  private static final String FREEDRIVE =
      "def " + FREEDRIVE_NAME + "():\n  freedrive_mode()\n  while True:\n    sync()\n  end\nend\n";

  private static final Pattern NAME = Pattern.compile("(?:def|sec)\\s+(\\w+)");
  private static final Pattern SYNTAX_LINE = Pattern.compile("syntax_error_on_line:(\\d{1,9}):");

  private final ServerContext serverContext;
  private final Robot robot;
  private final PeerLog log;
  private final CompileLanes compiler;
  private final TextBudget budget = new TextBudget();
  private final List<Consumer<ScriptTrouble>> listeners = new CopyOnWriteArrayList<>();

  /** For all clients of one controller. */
  public ScriptHandler(ServerContext serverContext) {
    this.serverContext = serverContext;
    robot = serverContext.robot();
    log = serverContext.log();
    compiler = new CompileLanes(robot::load);
  }

  /**
   * Has {@code listener} told what did not run.
   *
   * @param listener called by the thread of the client that sent it
   */
  public void onTrouble(Consumer<ScriptTrouble> listener) {
    listeners.add(listener);
  }

  /**
   * The conversation with a client that has just connected and may send scripts.
   *
   * @param left runs when the client has gone
   */
  public Session session(Connection connection, Runnable left) {
    return new ScriptSession(
        new ScriptSession.Client(connection, serverContext.remote().mayControl(), left),
        this,
        log,
        new ScriptFramer(budget));
  }

  /**
   * The conversation with a client of a read-only port: whatever it sends is ignored.
   *
   * @param left runs when the client has gone
   */
  public static Session readOnly(Runnable left) {
    return new ReadOnlySession(left);
  }

  /** A client that may only read has sent an item. */
  void refuse(String client) {
    log.write(Level.WARNING, text("sentAScriptInLocalControl", client));
    tell(new ScriptTrouble.ReadOnly());
  }

  /**
   * Carries out an item; comes back when it has had its frame.
   *
   * @param client for messages
   */
  void accept(ScriptItem item, String client) {
    switch (item) {
      case ScriptItem.Program program -> run(source(program.text()), client);
      case ScriptItem.Line line -> {
        Optional<RawCommand> command = RawCommand.read(line.text());
        if (command.isPresent()) {
          carryOut(command.get(), client);
        } else {
          run(sourceOf(UNNAMED, line.text()), client);
        }
      }
    }
  }

  private static Source source(String text) {
    Matcher name = NAME.matcher(text);
    return sourceOf(name.lookingAt() ? name.group(1) : UNNAMED, text);
  }

  private static Source sourceOf(String name, String text) {
    return Source.of(name, text.getBytes(StandardCharsets.ISO_8859_1));
  }

  private void run(Source source, String client) {
    LoadResult loadResult = compiler.load(source);
    if (loadResult.program().isEmpty()) {
      reportErrors(source, loadResult, client);
      return;
    }
    Program program = loadResult.program().get();
    // that a secondary program has failed comes with the events of the frame
    refusal(robot.ask(start(program), Deadline.NONE))
        .ifPresent(why -> notStarted(program, client, ByteText.asBytes(why)));
  }

  private void notStarted(Program program, String client, String why) {
    log.write(Level.WARNING, text("programNotStarted", program.name(), client, why));
    tell(new ScriptTrouble.NotStarted(why));
  }

  /** Why a command was not carried out; what has failed stands in the log already. */
  private static Optional<String> refusal(Reply reply) {
    return reply instanceof Reply.Failed ? Optional.empty() : reply.complaint();
  }

  private static Command start(Program program) {
    return program.secondary()
        ? new ProgramCommand.RunSecondary(program)
        : new ProgramCommand.ReplaceProgram(program);
  }

  private void reportErrors(Source source, LoadResult loadResult, String client) {
    List<Diagnostic> errors =
        loadResult.diagnostics().stream().filter(Diagnostic::isError).toList();
    Diagnostic first = errors.getFirst();
    int start = Math.min(first.range().start(), source.text().length());
    log.write(
        Level.ERROR,
        text(
            errors.size() > 1 ? "scriptDoesNotCompileAndMore" : "scriptDoesNotCompile",
            client,
            source.name(),
            source.line(start),
            source.column(start),
            first.message(),
            errors.size() - 1));
    tell(notCompiled(source, first));
  }

  /** In the controller's own words, which may give up on a later line than the fault is on. */
  static ScriptTrouble.NotCompiled notCompiled(Source source, Diagnostic error) {
    int start = Math.min(error.range().start(), source.text().length());
    int line = source.line(start);
    int column = source.column(start);
    Matcher gaveUp = SYNTAX_LINE.matcher(error.wireText());
    if (gaveUp.lookingAt() && Integer.parseInt(gaveUp.group(1)) != line) {
      line = Integer.parseInt(gaveUp.group(1));
      column = 1;
    }
    String text = error.wireText().isEmpty() ? error.message() : error.wireText();
    return new ScriptTrouble.NotCompiled(line, column, text);
  }

  private void tell(ScriptTrouble trouble) {
    listeners.forEach(each -> each.accept(trouble));
  }

  private void carryOut(RawCommand command, String client) {
    switch (command) {
      case RawCommand.PowerOn on -> submit(new SafetyCommand.PowerOn(), "power on", client);
      case RawCommand.PowerOff off -> submit(new SafetyCommand.PowerOff(), "power off", client);
      case RawCommand.Run run -> {
        if (robot.state().program().name().equals(FREEDRIVE_NAME)) {
          submit(new ProgramCommand.StopProgram(), "stop program", client);
        }
        submit(new SafetyCommand.ReleaseBrakes(), "set robotmode run", client);
      }
      case RawCommand.Freedrive freedrive -> run(source(FREEDRIVE), client);
      case RawCommand.UnlockProtectiveStop unlock ->
          submit(
              new SafetyCommand.UnlockProtectiveStop(true), "set unlock protective stop", client);
      case RawCommand.StopProgram stop ->
          submit(new ProgramCommand.StopProgram(), "stop program", client);
      case RawCommand.SetSpeed speed ->
          submit(new BoxCommand.SetSpeedFraction(client, speed.fraction()), "set speed", client);
      case RawCommand.ChooseArm choice ->
          log.write(
              Level.INFO, text(choice.real() ? "asksForRealArm" : "asksForSimulatedArm", client));
      case RawCommand.AnswerRequest answer -> answer(answer, client);
    }
  }

  private void submit(Command command, String name, String client) {
    refusal(robot.ask(command, Deadline.NONE))
        .ifPresent(
            why ->
                log.write(
                    Level.WARNING, text("commandRefused", name, client, ByteText.asBytes(why))));
  }

  private void answer(RawCommand.AnswerRequest answer, String client) {
    Optional<Question> question =
        robot.state().openQuestions().stream()
            .filter(each -> each.number() == answer.number())
            .findFirst();
    if (question.isEmpty()) {
      submit(new MessageCommand.AnswerPopup(answer.number()), "request_value", client);
      return;
    }
    try {
      submit(
          new MessageCommand.AnswerQuestion(
              answer.number(), question.get().kind().read(answer.value())),
          "request_value",
          client);
    } catch (IllegalArgumentException e) {
      log.write(Level.WARNING, text("requestValueRefused", client, e.getMessage()));
    }
  }
}
