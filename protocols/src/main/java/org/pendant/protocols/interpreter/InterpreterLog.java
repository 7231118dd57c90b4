package org.pendant.protocols.interpreter;

import static org.pendant.protocols.interpreter.InterpreterTexts.text;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.net.FaultGuard;
import org.pendant.protocols.server.ServerContext;
import org.pendant.script.vm.InterpreterJournal;

/** Interpreter log: keeps the log files up to date, in a thread of its own. */
final class InterpreterLog implements AutoCloseable {
  private final ServerContext serverContext;
  private final InterpreterJournal journal;
  private final LogFiles files;
  private final Consumer<ControllerState> listener = this::look;
  private final Thread thread;
  private volatile boolean closing;
  private volatile long written;
  private boolean failed;

  private InterpreterLog(ServerContext serverContext, Path folder) {
    this.serverContext = serverContext;
    journal = serverContext.robot().interpreterJournal();
    files = new LogFiles(folder);
    written = journal.newest();
    thread = Thread.ofVirtual().name("interpreter log").unstarted(this::run);
  }

  static InterpreterLog start(ServerContext serverContext, Path folder) {
    InterpreterLog log = new InterpreterLog(serverContext, folder);
    log.thread.start();
    serverContext.frames().add(log.listener);
    return log;
  }

  private void look(ControllerState state) {
    if (journal.newest() != written) {
      LockSupport.unpark(thread);
    }
  }

  private void run() {
    FaultGuard guard = new FaultGuard(text("theInterpreterLog"), serverContext.log());
    while (!closing) {
      guard.run(this::write);
      LockSupport.park(this);
    }
    write();
  }

  private void write() {
    for (InterpreterJournal.Entry each : journal.since(written)) {
      if (each.number() > written + 1) {
        serverContext
            .log()
            .write(Level.WARNING, text("eventsNotWritten", each.number() - written - 1));
      }
      try {
        files.write(each.event());
        failed = false;
      } catch (IOException e) {
        complain(e);
      }
      written = each.number();
    }
  }

  /** Once, until writing works again. */
  private void complain(IOException trouble) {
    if (!failed) {
      failed = true;
      serverContext.log().write(Level.WARNING, text("logTrouble", trouble));
    }
  }

  /** Writes what is left and ends. */
  @Override
  public void close() {
    serverContext.frames().remove(listener);
    closing = true;
    LockSupport.unpark(thread);
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
