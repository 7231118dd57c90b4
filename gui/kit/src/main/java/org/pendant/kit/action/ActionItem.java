package org.pendant.kit.action;

import com.formdev.flatlaf.ui.FlatCheckBoxMenuItemUI;
import com.formdev.flatlaf.ui.FlatMenuItemRenderer;
import com.formdev.flatlaf.ui.FlatMenuItemUI;
import com.formdev.flatlaf.ui.FlatRadioButtonMenuItemUI;
import java.awt.Font;
import java.util.Locale;
import javax.swing.Icon;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;

/**
 * Actions in menus, with a mark for those that have something on or off, and with their keys
 * written as everywhere else in the window.
 */
public final class ActionItem {
  private ActionItem() {}

  /**
   * The item of an action as it can be done now.
   *
   * @throws IllegalArgumentException if there is no such action
   */
  public static JMenuItem of(ActionTable actions, String id) {
    return of(actions, id, "");
  }

  /**
   * As {@link #of(ActionTable, String)}, in a menu that says how its titles begin.
   *
   * @param said how the action's title begins; the item goes without it
   */
  public static JMenuItem of(ActionTable actions, String id, String said) {
    Action action =
        actions.find(id).orElseThrow(() -> new IllegalArgumentException("no action " + id));
    JMenuItem item = marked(action);
    item.setText(without(said, action.title()));
    item.getAccessibleContext().setAccessibleName(action.title());
    item.setName("menu-" + id.replace('.', '-'));
    actions.strokeOf(id).ifPresent(item::setAccelerator);
    item.setEnabled(action.enabled().getAsBoolean());
    String reason = actions.reason(id);
    item.setToolTipText(reason.isEmpty() ? null : reason);
    item.addActionListener(event -> actions.run(id));
    return item;
  }

  private static JMenuItem marked(Action action) {
    if (action.mark().isEmpty()) {
      return new Plain();
    }
    JMenuItem item =
        switch (action.mark().get()) {
          case Action.Mark.Check _ -> new Check();
          case Action.Mark.Choice _ -> new Choice();
        };
    item.setSelected(action.mark().get().on().getAsBoolean());
    return item;
  }

  private static String without(String said, String title) {
    if (!title.startsWith(said)) {
      return title;
    }
    String rest = title.substring(said.length()).replaceFirst("^[:\uff1a]? *", "");
    return rest.substring(0, 1).toUpperCase(Locale.ROOT) + rest.substring(1);
  }

  @SuppressWarnings("serial") // never written to a stream
  private static final class Plain extends JMenuItem {
    @Override
    public void updateUI() {
      setUI(
          new FlatMenuItemUI() {
            @Override
            protected FlatMenuItemRenderer createRenderer() {
              return new Renderer(
                  menuItem, checkIcon, arrowIcon, acceleratorFont, acceleratorDelimiter);
            }
          });
    }
  }

  @SuppressWarnings("serial") // never written to a stream
  private static final class Check extends JCheckBoxMenuItem {
    @Override
    public void updateUI() {
      setUI(
          new FlatCheckBoxMenuItemUI() {
            @Override
            protected FlatMenuItemRenderer createRenderer() {
              return new Renderer(
                  menuItem, checkIcon, arrowIcon, acceleratorFont, acceleratorDelimiter);
            }
          });
    }
  }

  @SuppressWarnings("serial") // never written to a stream
  private static final class Choice extends JRadioButtonMenuItem {
    @Override
    public void updateUI() {
      setUI(
          new FlatRadioButtonMenuItemUI() {
            @Override
            protected FlatMenuItemRenderer createRenderer() {
              return new Renderer(
                  menuItem, checkIcon, arrowIcon, acceleratorFont, acceleratorDelimiter);
            }
          });
    }
  }

  /** The look's own names of keys are those of Java's constants, such as Equals. */
  private static final class Renderer extends FlatMenuItemRenderer {
    Renderer(JMenuItem item, Icon check, Icon arrow, Font font, String delimiter) {
      super(item, check, arrow, font, delimiter);
    }

    @Override
    protected String getTextForAccelerator(KeyStroke keys) {
      return KeyText.shown(keys);
    }
  }
}
