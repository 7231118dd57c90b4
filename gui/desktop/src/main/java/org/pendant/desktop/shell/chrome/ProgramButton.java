package org.pendant.desktop.shell.chrome;

import static org.pendant.desktop.shell.chrome.ChromeTexts.text;

import java.awt.Rectangle;
import javax.swing.JButton;
import javax.swing.JPopupMenu;
import javax.swing.SwingConstants;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.icon.Glyph;

/** Program button: the name of the open program; it opens a menu of other programs. */
@SuppressWarnings("serial") // never written to a stream
final class ProgramButton extends JButton {
  private final transient ProgramMenu menu;

  ProgramButton(ProgramMenu menu) {
    super(Glyph.DOWN.icon(14));
    this.menu = menu;
    setName("program-name");
    setHorizontalAlignment(SwingConstants.LEADING);
    setHorizontalTextPosition(SwingConstants.LEADING);
    putClientProperty("JButton.buttonType", "toolBarButton");
    putClientProperty("FlatLaf.styleClass", "h3");
    getAccessibleContext().setAccessibleName(text("openProgram"));
    addActionListener(event -> open());
  }

  /** Opens the menu below the name. */
  void open() {
    JPopupMenu popup = menu.popup();
    Rectangle place = getVisibleRect();
    popup.show(this, place.x, place.y + place.height);
  }

  void show(ProgramDocument document) {
    String name = document.name() + (document.modified() ? " \u2022" : "");
    setText(name);
    String place =
        document.file().map(Object::toString).orElse(text("nameNotSavedYet", document.name()));
    setToolTipText(document.modified() ? text("modified", place) : place);
    getAccessibleContext().setAccessibleDescription(getToolTipText());
  }
}
