package org.pendant.kit.action;

import com.formdev.flatlaf.ui.FlatMenuItemRenderer;
import com.formdev.flatlaf.ui.FlatMenuItemUI;
import java.awt.Font;
import javax.swing.Icon;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;

/** An action in a menu, with its key written as everywhere else in the window. */
@SuppressWarnings("serial") // never written to a stream
public final class ActionItem extends JMenuItem {
  private ActionItem(String title) {
    super(title);
  }

  /**
   * The item of an action as it can be done now.
   *
   * @throws IllegalArgumentException if there is no such action
   */
  public static ActionItem of(ActionTable actions, String id) {
    Action action =
        actions.find(id).orElseThrow(() -> new IllegalArgumentException("no action " + id));
    ActionItem item = new ActionItem(action.title());
    item.setName("menu-" + id.replace('.', '-'));
    actions.strokeOf(id).ifPresent(item::setAccelerator);
    item.setEnabled(action.enabled().getAsBoolean());
    String reason = actions.reason(id);
    item.setToolTipText(reason.isEmpty() ? null : reason);
    item.addActionListener(event -> actions.run(id));
    return item;
  }

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
