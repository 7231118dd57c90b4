package org.pendant.window;

import java.awt.EventQueue;
import java.util.Arrays;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import javax.swing.JComponent;
import javax.swing.RepaintManager;

/** Notices who touches a visible component outside of the dispatch thread. */
final class PaintGuard extends RepaintManager {
  private final Queue<String> complaints = new ConcurrentLinkedQueue<>();

  /** What happened so far, a stack trace each. */
  Queue<String> complaints() {
    return complaints;
  }

  @Override
  public synchronized void addInvalidComponent(JComponent component) {
    look(component);
    super.addInvalidComponent(component);
  }

  @Override
  public void addDirtyRegion(JComponent component, int x, int y, int w, int h) {
    look(component);
    super.addDirtyRegion(component, x, y, w, h);
  }

  private void look(JComponent component) {
    if (component.isShowing() && !EventQueue.isDispatchThread()) {
      Thread thread = Thread.currentThread();
      complaints.add(
          component.getClass().getName()
              + " from thread "
              + thread.getName()
              + ": "
              + Arrays.toString(thread.getStackTrace()));
    }
  }
}
