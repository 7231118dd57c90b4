package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import java.awt.AWTEvent;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JLayer;
import javax.swing.JScrollBar;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.plaf.LayerUI;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.View;
import org.pendant.kit.theme.Palette;

/**
 * Locked view, in which people act on the robot: while it shows the past it can be looked at only,
 * and says so to those who try.
 */
public final class HeldView implements View {
  private final View view;
  private final Glass glass;
  private Optional<JLayer<JComponent>> layer = Optional.empty();

  /** {@code tell} hears a sentence whenever the user wants to act on the past. */
  public HeldView(View view, LookBack lookBack, Consumer<String> tell) {
    this(view, lookBack, tell, false);
  }

  /**
   * As {@link #HeldView(View, LookBack, Consumer)}.
   *
   * @param selectable whether rows of its tables can be selected meanwhile
   */
  public HeldView(View view, LookBack lookBack, Consumer<String> tell, boolean selectable) {
    this.view = view;
    glass =
        new Glass(
            lookBack,
            selectable,
            () ->
                tell.accept(
                    text(lookBack.ofFile() ? "showsARecording" : "showsThePast", view.title())));
    lookBack.addListener(() -> layer.ifPresent(JComponent::repaint));
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
    if (layer.isEmpty()) {
      layer = Optional.of(new JLayer<>(view.component(), glass));
    }
    return layer.get();
  }

  @Override
  public void refresh(ControllerState state) {
    view.refresh(state);
  }

  /** Takes clicks and keys while the past is shown; wheels, scroll bars and tabs still work. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Glass extends LayerUI<JComponent> {
    private static final int VEIL = 28;

    private final transient LookBack lookBack;
    private final boolean selectable;
    private final transient Runnable refused;

    Glass(LookBack lookBack, boolean selectable, Runnable refused) {
      this.lookBack = lookBack;
      this.selectable = selectable;
      this.refused = refused;
    }

    @Override
    public void installUI(JComponent component) {
      super.installUI(component);
      ((JLayer<?>) component)
          .setLayerEventMask(
              AWTEvent.MOUSE_EVENT_MASK
                  | AWTEvent.MOUSE_MOTION_EVENT_MASK
                  | AWTEvent.KEY_EVENT_MASK);
    }

    @Override
    public void uninstallUI(JComponent component) {
      ((JLayer<?>) component).setLayerEventMask(0);
      super.uninstallUI(component);
    }

    @Override
    protected void processMouseEvent(MouseEvent event, JLayer<? extends JComponent> layer) {
      hold(event, event.getID() == MouseEvent.MOUSE_PRESSED);
    }

    @Override
    protected void processMouseMotionEvent(MouseEvent event, JLayer<? extends JComponent> layer) {
      if (event.getID() == MouseEvent.MOUSE_DRAGGED) {
        hold(event, false);
      }
    }

    @Override
    protected void processKeyEvent(KeyEvent event, JLayer<? extends JComponent> layer) {
      boolean moves =
          switch (event.getKeyCode()) {
            case KeyEvent.VK_TAB, KeyEvent.VK_ESCAPE -> true;
            case KeyEvent.VK_UP,
                KeyEvent.VK_DOWN,
                KeyEvent.VK_LEFT,
                KeyEvent.VK_RIGHT,
                KeyEvent.VK_HOME,
                KeyEvent.VK_END ->
                selectable && event.getComponent() instanceof JTable;
            case KeyEvent.VK_F2 -> false;
            default -> event.isControlDown() || event.isAltDown() || functionKey(event);
          };
      if (!moves) {
        hold(event, event.getID() == KeyEvent.KEY_PRESSED);
      }
    }

    private static boolean functionKey(KeyEvent event) {
      return event.getKeyCode() >= KeyEvent.VK_F1 && event.getKeyCode() <= KeyEvent.VK_F12;
    }

    private void hold(InputEvent event, boolean tells) {
      if (!lookBack.back()
          || event.getComponent() instanceof JScrollBar
          || event.getComponent() instanceof JTabbedPane
          || selects(event)
          || event.getID() == MouseEvent.MOUSE_RELEASED
          || event.getID() == MouseEvent.MOUSE_ENTERED
          || event.getID() == MouseEvent.MOUSE_EXITED) {
        return;
      }
      event.consume();
      if (tells) {
        refused.run();
      }
    }

    private boolean selects(InputEvent event) {
      return selectable
          && event.getComponent() instanceof JTable
          && event instanceof MouseEvent mouse
          && mouse.getClickCount() <= 1
          && SwingUtilities.isLeftMouseButton(mouse);
    }

    @Override
    public void paint(Graphics pen, JComponent component) {
      super.paint(pen, component);
      if (lookBack.back()) {
        Color color = Palette.accent();
        pen.setColor(new Color(color.getRed(), color.getGreen(), color.getBlue(), VEIL));
        pen.fillRect(0, 0, component.getWidth(), component.getHeight());
      }
    }
  }
}
