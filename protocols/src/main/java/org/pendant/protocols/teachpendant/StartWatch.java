package org.pendant.protocols.teachpendant;

import static org.pendant.protocols.teachpendant.TeachPendantTexts.text;

import java.util.concurrent.atomic.AtomicInteger;
import org.pendant.controller.Robot;
import org.pendant.controller.installation.StartEdge;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.state.ControllerState;

/**
 * Start input watch: plays the loaded program when the input asks for it that the installation
 * names.
 */
public final class StartWatch {
  private final Robot robot;
  private final RemotePendant remotePendant;
  private final StartEdge edge = new StartEdge();

  /** Edges that have not been answered yet. */
  private final AtomicInteger asked = new AtomicInteger();

  /**
   * A watch that looks at nothing yet.
   *
   * @param remotePendant has the loaded program
   */
  public StartWatch(Robot robot, RemotePendant remotePendant) {
    this.robot = robot;
    this.remotePendant = remotePendant;
  }

  /** Looks at a frame; does not wait. One thread hands over all of them, in order. */
  public void look(ControllerState state) {
    if (edge.look(robot.installation().startUp(), state.io()) && asked.getAndIncrement() == 0) {
      Thread.ofVirtual().name("start by input").start(this::play);
    }
  }

  private void play() {
    int answered;
    do {
      answered = asked.get();
      playOnce();
    } while (asked.addAndGet(-answered) > 0);
  }

  /** A fault is logged, as the next edge must be answered all the same. */
  private void playOnce() {
    try {
      remotePendant
          .play()
          .complaint()
          .ifPresent(why -> remotePendant.log(Level.WARNING, text("startByInput", why)));
    } catch (RuntimeException e) {
      remotePendant.log(Level.ERROR, text("startByInputInternalError", e));
    }
  }
}
