package org.pendant.kit.action;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Point;
import java.awt.event.MouseEvent;
import javax.swing.Icon;
import javax.swing.JToolTip;
import org.pendant.kit.text.Messages;

/** A button that does an action of the table and shows whether it can be done, and why not. */
@SuppressWarnings("serial") // never written to a stream
public final class ActionButton extends RoomyButton {
  private static final int GAP = 4;

  private final transient ActionTable actions;
  private final String id;
  private String shown = "";

  /** A button for the action {@code id}. */
  public ActionButton(ActionTable actions, String id, String text, Icon icon) {
    super(text, icon);
    this.actions = actions;
    this.id = id;
    setName(id.replace('.', '-'));
    setFocusable(true);
    addActionListener(event -> actions.run(id));
    refresh();
  }

  /** Shows whether the action can be done now. */
  public void refresh() {
    boolean enabled =
        actions.find(id).map(Action::enabled).filter(e -> e.getAsBoolean()).isPresent();
    if (enabled != isEnabled()) {
      setEnabled(enabled);
    }
    String tip = tip();
    if (!tip.equals(shown)) {
      shown = tip;
      setToolTipText(tip);
      getAccessibleContext().setAccessibleName(actions.find(id).map(Action::title).orElse(id));
      getAccessibleContext().setAccessibleDescription(tip);
    }
  }

  /** Above the button: under the pointer it would lie over the buttons beside this one. */
  @Override
  public Point getToolTipLocation(MouseEvent event) {
    JToolTip tip = createToolTip();
    tip.setTipText(getToolTipText());
    return new Point(0, -tip.getPreferredSize().height - UIScale.scale(GAP));
  }

  private String tip() {
    String title = actions.find(id).map(Action::title).orElse(id);
    String keys = KeyText.shown(actions.keysOf(id));
    String reason = actions.reason(id);
    String whole = keys.isEmpty() ? title : title + " (" + keys + ")";
    return reason.isEmpty() ? whole : Messages.told(whole, reason);
  }
}
