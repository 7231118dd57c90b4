package org.pendant.desktop.editor;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import org.pendant.kit.action.ActionItem;
import org.pendant.kit.action.ActionTable;

/**
 * Text menu: what can be done at a place of a script, by the right button there, or at the caret by
 * the key for context menus.
 */
final class TextMenu {
  private static final List<List<String>> GROUPS =
      List.of(
          List.of("edit.cut", "edit.copy", "edit.paste"),
          List.of("editor.definition", "editor.references", "editor.rename", "editor.quick-fix"),
          List.of("editor.comment", "editor.format"),
          List.of("editor.breakpoint", "debug.conditional-breakpoint", "debug.run-to-line"),
          List.of("help.context"));

  private final JTextComponent text;
  private final ActionTable actions;

  private TextMenu(JTextComponent text, ActionTable actions) {
    this.text = text;
    this.actions = actions;
  }

  /** Has the menu opened in {@code text}, with those of its actions that there are then. */
  static void addTo(JTextComponent text, ActionTable actions) {
    TextMenu menu = new TextMenu(text, actions);
    text.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            menu.openAt(event);
          }

          @Override
          public void mouseReleased(MouseEvent event) {
            menu.openAt(event);
          }
        });
    text.getInputMap().put(KeyStroke.getKeyStroke("CONTEXT_MENU"), "text-menu");
    text.getActionMap()
        .put(
            "text-menu",
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent event) {
                menu.openAtCaret();
              }
            });
  }

  private void openAt(MouseEvent event) {
    if (!event.isPopupTrigger()) {
      return;
    }
    text.requestFocusInWindow();
    int offset = text.viewToModel2D(event.getPoint());
    // What is selected stays so where it is clicked, to be cut or copied.
    if (offset < text.getSelectionStart() || offset >= text.getSelectionEnd()) {
      text.setCaretPosition(offset);
    }
    open(event.getPoint());
  }

  private void openAtCaret() {
    try {
      Rectangle2D caret = text.modelToView2D(text.getCaretPosition());
      Rectangle line = caret.getBounds();
      open(new Point(line.x, line.y + line.height));
    } catch (BadLocationException e) {
      throw new IllegalStateException("the caret is nowhere", e);
    }
  }

  private void open(Point place) {
    JPopupMenu menu = menu(actions);
    if (menu.getComponentCount() > 0) {
      menu.show(text, place.x, place.y);
    }
  }

  /** The menu as it is now; actions that there are not are left out. */
  static JPopupMenu menu(ActionTable actions) {
    JPopupMenu menu = new JPopupMenu();
    menu.setName("text-menu");
    for (List<String> group : GROUPS) {
      List<String> there = group.stream().filter(id -> actions.find(id).isPresent()).toList();
      if (!there.isEmpty() && menu.getComponentCount() > 0) {
        menu.addSeparator();
      }
      there.forEach(id -> menu.add(ActionItem.of(actions, id)));
    }
    return menu;
  }
}
