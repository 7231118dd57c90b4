package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Function;
import org.pendant.controller.Robot;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.script.function.ScriptPlace;

/**
 * Log printer: prints what a served controller says, in a thread of its own: no other thread waits
 * for a reader that is slow.
 */
final class LogPrinter implements AutoCloseable {
  /** Popups and questions that wait for a slow reader; more are not printed. */
  private static final int MAX_WAITING = 1000;

  private final Robot robot;
  private final Console console;
  private final String prefix;
  private final Function<ScriptPlace, Optional<String>> origin;
  private final Queue<String> prompts = new ConcurrentLinkedQueue<>();
  private final AtomicInteger waiting = new AtomicInteger();
  private final Thread thread;
  private volatile long newest;
  private volatile boolean closing;
  private long printed;

  /**
   * Begins to print to {@code console}.
   *
   * @param prefix stands before each line
   * @param origin what is to be said of where a line of a program comes from
   */
  LogPrinter(
      Robot robot, Console console, String prefix, Function<ScriptPlace, Optional<String>> origin) {
    this.origin = origin;
    this.robot = robot;
    this.console = console;
    this.prefix = prefix;
    thread = Thread.ofPlatform().daemon().name("log printer").start(this::run);
  }

  /** A frame has ended; never waits. */
  void look(ControllerState state) {
    for (Popup popup : state.newPopups()) {
      say(Report.popup(popup));
    }
    for (Question question : state.newQuestions()) {
      say(text("question", question.number(), ByteText.decoded(question.text())));
    }
    if (state.newestEntry() != newest) {
      newest = state.newestEntry();
      LockSupport.unpark(thread);
    }
  }

  private void say(String prompt) {
    if (waiting.get() < MAX_WAITING) {
      waiting.incrementAndGet();
      prompts.add(prompt);
      LockSupport.unpark(thread);
    }
  }

  private void run() {
    while (!closing) {
      print();
      LockSupport.park(this);
    }
    print();
    console.flush();
  }

  private void print() {
    for (String prompt = prompts.poll(); prompt != null; prompt = prompts.poll()) {
      waiting.decrementAndGet();
      console.complain(prefix + prompt);
    }
    for (LogEntry entry : robot.logSince(printed)) {
      long missed = entry.number() - printed - 1;
      if (missed > 0) {
        console.complain(prefix + text("linesNotPrinted", missed));
      }
      print(entry);
      printed = entry.number();
    }
    console.flush();
  }

  private void print(LogEntry entry) {
    switch (entry.origin()) {
      case SCRIPT -> console.printBytes(prefix + entry.text());
      case CONTROLLER, SAFETY, PROTOCOL, ENDING ->
          console.complain(
              prefix
                  + Report.logEntry(entry)
                  + entry.place().flatMap(origin).map(each -> " (" + each + ")").orElse(""));
    }
  }

  /** Prints what is left and ends. */
  @Override
  public void close() {
    closing = true;
    LockSupport.unpark(thread);
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
