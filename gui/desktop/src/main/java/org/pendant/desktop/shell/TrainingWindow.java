package org.pendant.desktop.shell;

import java.awt.Graphics2D;
import java.awt.image.VolatileImage;
import java.util.ArrayDeque;
import java.util.Deque;
import javax.swing.JFrame;
import javax.swing.JWindow;
import javax.swing.Timer;
import org.pendant.kit.fault.Faults;

/**
 * Training window: uses a window that is never shown: its views are made, filled and drawn, and a
 * program runs. Only the dispatch thread calls it. What takes a window on the display is trained
 * with one of a single point, which nobody sees.
 */
final class TrainingWindow {
  private static final int TURN_MS = 33;
  private static final int WIDTH = 1440;
  private static final int HEIGHT = 900;

  private final DesktopWindow window;
  private final VolatileImage picture;
  private final JWindow point = new JWindow();

  /** What is still to be done, one of it a turn. */
  private final Deque<Runnable> steps = new ArrayDeque<>();

  private final Timer turns = Faults.timer(TURN_MS, this::turn);

  TrainingWindow(DesktopWindow window) {
    this.window = window;
    JFrame frame = window.frame();
    frame.setSize(WIDTH, HEIGHT);
    frame.addNotify();
    // what the display itself draws on takes other classes than a picture in memory
    picture = frame.createVolatileImage(WIDTH, HEIGHT);
    point.setFocusableWindowState(false);
    point.setSize(1, 1);
  }

  /** Begins; the window is closed at the end. */
  void begin() {
    steps.add(() -> point.setVisible(true));
    steps.add(window::fill);
    steps.add(window::lookAround);
    steps.add(() -> window.perform("program.run"));
    for (String view : window.views()) {
      steps.add(() -> window.show(view));
    }
    steps.add(() -> window.perform("program.stop"));
    // what a user sees first comes last: how it looks then is what is closed
    steps.add(() -> window.show("run"));
    turns.start();
  }

  private void turn() {
    if (steps.isEmpty()) {
      turns.stop();
      point.dispose();
      window.dispose();
      return;
    }
    try {
      steps.remove().run();
    } finally {
      window.refreshAll();
      draw();
    }
  }

  private void draw() {
    window.frame().validate();
    Graphics2D pen = picture.createGraphics();
    window.frame().getRootPane().paint(pen);
    pen.dispose();
  }
}
