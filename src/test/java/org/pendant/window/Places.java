package org.pendant.window;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import javax.swing.JComponent;
import javax.swing.JTable;

/** Where things are on the screen, brought into view where that is possible. */
final class Places {
  private Places() {}

  /** Where the visible part of {@code name} is. */
  static Rectangle of(String name) throws InterruptedException {
    return dispatched(() -> Eyes.place(find(name)));
  }

  /** As people scroll to what they want to click on, and wait until it stands still. */
  static Rectangle inView(String name) throws InterruptedException {
    return still(
        () -> {
          if (find(name) instanceof JComponent inside) {
            inside.scrollRectToVisible(new Rectangle(inside.getSize()));
          }
          Toolkit.getDefaultToolkit().sync();
          return Eyes.place(find(name));
        });
  }

  /** {@code list=text}: a row of a list or tree. */
  static Rectangle row(String what) throws InterruptedException {
    String[] words = what.split("=", 2);
    return still(() -> Rows.place(find(words[0]), words[1]));
  }

  /** {@code container=text}: a button, for what has no stable name of its own. */
  static Rectangle button(String what) throws InterruptedException {
    String[] words = what.split("=", 2);
    return still(
        () ->
            Eyes.inside(find(words[0]), words[1])
                .map(Eyes::place)
                .orElseThrow(() -> new IllegalArgumentException("nothing reads " + words[1])));
  }

  /** {@code table=text}. */
  static Rectangle cell(String what) throws InterruptedException {
    String[] words = what.split("=", 2);
    return still(
        () -> {
          if (!(find(words[0]) instanceof JTable table)) {
            throw new IllegalArgumentException(words[0] + " is not a table");
          }
          return Eyes.cell(table, words[1])
              .orElseThrow(() -> new IllegalArgumentException("no cell reads " + words[1]));
        });
  }

  /** {@code tabs=title}. */
  static Rectangle tab(String what) throws InterruptedException {
    String[] words = what.split("=", 2);
    return still(() -> Eyes.tab(find(words[0]), words[1]));
  }

  /** Two questions in a row get the same answer. */
  private static Rectangle still(Callable<Rectangle> where) throws InterruptedException {
    Rectangle place = dispatched(where);
    for (Rectangle next = dispatched(where); !next.equals(place); next = dispatched(where)) {
      place = next;
    }
    return place;
  }

  /** What is visible under {@code name}. Only the dispatch thread calls it. */
  static Component find(String name) {
    return Eyes.find(name)
        .orElseThrow(() -> new IllegalArgumentException("nothing visible is named " + name));
  }

  /** Asks on the dispatch thread. */
  static <T> T dispatched(Callable<T> question) throws InterruptedException {
    FutureTask<T> task = new FutureTask<>(question);
    try {
      EventQueue.invokeAndWait(task);
      return task.get();
    } catch (ExecutionException e) {
      throw new IllegalArgumentException(e.getCause().getMessage(), e);
    } catch (InvocationTargetException e) {
      throw new IllegalStateException(e);
    }
  }
}
