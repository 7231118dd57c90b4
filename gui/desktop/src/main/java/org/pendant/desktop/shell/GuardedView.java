package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.Graphics;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.View;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.theme.Palette;
import org.pendant.kit.theme.WrappedText;

/**
 * Guarded view, which harms no other when it throws. A strip above it says so as long as it does:
 * what it shows may be old then, and must not be taken for the state of the robot.
 */
final class GuardedView implements View {
  /** So many turns pass after one that has failed, about a second. */
  static final int REST_TURNS = 30;

  private final View view;
  private final JPanel whole = new Whole();
  private final Strip strip = new Strip();
  private boolean undrawn;
  private boolean old;
  private int rest;

  GuardedView(View view) {
    this.view = view;
    strip.setName("failed-" + view.id());
    strip.setVisible(false);
    whole.add(strip, BorderLayout.NORTH);
  }

  /** What is shown; the view's components are made when they are first in front in a window. */
  @SuppressWarnings("serial") // never written to a stream
  private final class Whole extends JPanel {
    private boolean filled;

    Whole() {
      super(new BorderLayout());
    }

    @Override
    public void addNotify() {
      if (isVisible()) {
        fill();
      }
      super.addNotify();
    }

    /** Tabs behind the one in front are not visible. */
    @Override
    public void setVisible(boolean visible) {
      if (visible && isDisplayable()) {
        fill();
      }
      super.setVisible(visible);
    }

    private void fill() {
      if (!filled) {
        filled = true;
        add(new Content(view.component()), BorderLayout.CENTER);
      }
    }
  }

  @Override
  public String id() {
    return view.id();
  }

  @Override
  public String title() {
    return view.title();
  }

  @Override
  public JComponent component() {
    return whole;
  }

  @Override
  public void refresh(ControllerState state) {
    if (rest > 0) {
      rest--;
      return;
    }
    boolean failed = true;
    try {
      view.refresh(state);
      failed = false;
    } catch (RuntimeException | Error fault) {
      rest = REST_TURNS;
      Faults.report(fault);
    }
    if (failed != old) {
      old = failed;
      tell();
    }
  }

  private void drawn(boolean failed) {
    if (failed != undrawn) {
      undrawn = failed;
      // Not while the window is being drawn.
      EventQueue.invokeLater(this::tell);
    }
  }

  private void tell() {
    if (undrawn) {
      strip.say(text("internalErrorCannotBeDrawnEverything", view.title()));
    } else if (old) {
      strip.say(text("internalErrorShowsAnOldState", view.title()));
    }
    strip.setVisible(undrawn || old);
  }

  /** Where the view is drawn. What cannot be drawn is left blank: half of it might mislead. */
  @SuppressWarnings("serial") // never written to a stream
  private final class Content extends JPanel {
    Content(JComponent component) {
      super(new BorderLayout());
      add(component);
    }

    @Override
    protected void paintChildren(Graphics pen) {
      // What is drawn of a part says nothing of the others.
      boolean all = pen.getClipBounds() == null || pen.getClipBounds().contains(getVisibleRect());
      try {
        super.paintChildren(pen);
        if (all) {
          drawn(false);
        }
      } catch (RuntimeException | Error fault) {
        Faults.report(fault);
        pen.setColor(getBackground());
        pen.fillRect(0, 0, getWidth(), getHeight());
        drawn(true);
      }
    }
  }

  /** Says that the view has failed. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Strip extends JPanel {
    private final WrappedText text = new WrappedText("", text("failedView"));

    Strip() {
      super(new BorderLayout(UIScale.scale(8), 0));
      setBackground(Palette.tint(Palette.error(), 0.16));
      int gap = UIScale.scale(6);
      setBorder(BorderFactory.createEmptyBorder(gap, 2 * gap, gap, 2 * gap));
      add(new JLabel(Glyph.WARNING.icon(16, Palette.error())), BorderLayout.WEST);
      add(text, BorderLayout.CENTER);
    }

    void say(String sentence) {
      text.setText(sentence);
    }
  }
}
