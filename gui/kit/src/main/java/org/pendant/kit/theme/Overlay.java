package org.pendant.kit.theme;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLayeredPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;

/**
 * Overlay: a panel that lies over a part of the window instead of a dialog: everything beside it
 * can be used. Escape in it closes it.
 */
public final class Overlay {
  private final JComponent under;
  private final Card card = new Card(new BorderLayout());
  private final ComponentAdapter follower =
      new ComponentAdapter() {
        @Override
        public void componentResized(ComponentEvent event) {
          place();
        }
      };
  private boolean open;
  private Optional<Component> focusBefore = Optional.empty();
  private Runnable escape = this::close;

  /**
   * An empty panel.
   *
   * @param under what it may cover; the rest of the window stays visible
   */
  public Overlay(String name, JComponent under, JComponent content) {
    this.under = under;
    card.setName(name);
    card.add(content, BorderLayout.CENTER);
    card.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke("ESCAPE"), "close");
    card.getActionMap()
        .put(
            "close",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                escape.run();
              }
            });
  }

  /** Does something else than closing when Escape is pressed in it. */
  public void onEscape(Runnable run) {
    escape = run;
  }

  /**
   * Takes Escape also while keys go elsewhere in the window, unless something there takes it: for
   * what stays open beside other work.
   */
  public void takeEscapeAnywhere() {
    card.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
        .put(KeyStroke.getKeyStroke("ESCAPE"), "close");
  }

  /** Whether it is open. */
  public boolean isOpen() {
    return open;
  }

  /** Opens it. */
  public void open() {
    if (isOpen()) {
      return;
    }
    remove();
    open = true;
    focusBefore =
        Optional.ofNullable(KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner());
    // again for each opening, as the scale may have changed
    card.setBorder(
        BorderFactory.createEmptyBorder(
            UIScale.scale(16), UIScale.scale(16), UIScale.scale(16), UIScale.scale(16)));
    layers().add(card, JLayeredPane.MODAL_LAYER);
    under.addComponentListener(follower);
    place();
  }

  /** Brings its window to the front: a key may have been pressed in another one. */
  public void bringToFront() {
    Window window = SwingUtilities.getWindowAncestor(under);
    if (!window.isFocused()) {
      window.toFront();
    }
  }

  /** Closes it; the focus goes back to where it was. */
  public void close() {
    if (!isOpen()) {
      return;
    }
    open = false;
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    if (!focusWithin() || !returnFocus()) {
      remove();
      return;
    }
    // What is typed meanwhile waits for the new owner; it would be lost with the old one.
    owner.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            owner.removeFocusListener(this);
            if (!open) {
              remove();
            }
          }
        });
  }

  private void remove() {
    if (card.getParent() instanceof JLayeredPane layers) {
      under.removeComponentListener(follower);
      layers.remove(card);
      layers.repaint();
    }
  }

  /**
   * Gives the focus back to where it was, if it is in here.
   *
   * @return whether it will be there
   */
  public boolean returnFocus() {
    return focusWithin()
        && focusBefore
            .filter(Component::isShowing)
            .filter(each -> !SwingUtilities.isDescendingFrom(each, card))
            .orElse(under)
            .requestFocusInWindow();
  }

  /** Gives the focus to a part of this; {@link #returnFocus} gives it back. */
  public void takeFocus(Component part) {
    if (!focusWithin()) {
      focusBefore =
          Optional.ofNullable(
              KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner());
    }
    part.requestFocusInWindow();
  }

  /** Whether keys go to this or to something in it. */
  public boolean focusWithin() {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    return owner != null && SwingUtilities.isDescendingFrom(owner, card);
  }

  private JLayeredPane layers() {
    return SwingUtilities.getRootPane(under).getLayeredPane();
  }

  /** Places it in the middle near the top, no larger than what it may cover. */
  public void place() {
    if (!isOpen()) {
      return;
    }
    Rectangle room = SwingUtilities.convertRectangle(under, under.getVisibleRect(), layers());
    int gap = UIScale.scale(16);
    Dimension wanted = card.getPreferredSize();
    int width = Math.min(wanted.width, room.width - 2 * gap);
    int height = Math.min(wanted.height, room.height - 2 * gap);
    card.setBounds(room.x + (room.width - width) / 2, room.y + gap, width, height);
    card.revalidate();
    layers().repaint();
  }
}
