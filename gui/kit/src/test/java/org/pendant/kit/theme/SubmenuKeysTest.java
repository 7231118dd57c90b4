package org.pendant.kit.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.event.ActionEvent;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.AbstractAction;
import javax.swing.AbstractButton;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class SubmenuKeysTest {
  private final MenuSelectionManager menus = MenuSelectionManager.defaultManager();
  private final JMenuItem close = new JMenuItem("Close");
  private final JMenuItem script = new JMenuItem("Script");
  private final JMenuItem table = new JMenuItem("Table");
  private final JMenu export = menu("Export", script, table);
  private final JMenu file = menu("File", close, export);
  private final JMenuBar bar = new JMenuBar();

  /** How often the key was left to Swing. */
  private int left;

  @SuppressWarnings("serial") // never written to a stream
  private final SubmenuKeys.Into key =
      new SubmenuKeys.Into(
          new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
              left++;
            }
          });

  private static JMenu menu(String title, JMenuItem... items) {
    JMenu menu = new JMenu(title);
    List.of(items).forEach(menu::add);
    return menu;
  }

  @BeforeEach
  void fillBar() {
    bar.add(file);
    bar.add(menu("Edit", new JMenuItem("Undo")));
  }

  @AfterEach
  void close() {
    menus.clearSelectedPath();
  }

  private void select(MenuElement... path) {
    menus.setSelectedPath(path);
  }

  private void right() {
    key.actionPerformed(new ActionEvent(bar, ActionEvent.ACTION_PERFORMED, ""));
  }

  /** The titles of what is selected, from the outermost menu on. */
  private String selected() {
    return Arrays.stream(menus.getSelectedPath())
        .filter(AbstractButton.class::isInstance)
        .map(each -> ((AbstractButton) each).getText())
        .collect(Collectors.joining(" > "));
  }

  @Test
  void theKeyLeadsIntoASubmenuThatThePointerHasOpened() {
    select(bar, file, file.getPopupMenu(), export, export.getPopupMenu());
    right();
    assertEquals("File > Export > Script", selected());
  }

  @Test
  void whatCannotBeUsedIsLeftOutAndASubmenuWithoutAnythingElseStaysAsItIs() {
    script.setEnabled(false);
    select(bar, file, file.getPopupMenu(), export, export.getPopupMenu());
    right();
    assertEquals("File > Export > Table", selected());

    table.setEnabled(false);
    select(bar, file, file.getPopupMenu(), export, export.getPopupMenu());
    right();
    assertEquals("File > Export", selected());
  }

  @Test
  void aMenuAtAPlaceHasSuchSubmenusToo() {
    JPopupMenu place = new JPopupMenu();
    place.setInvoker(bar); // a look that is installed asks what it belongs to
    JMenu turn = menu("Turn", new JMenuItem("Left"), new JMenuItem("Right"));
    place.add(turn);
    select(place, turn, turn.getPopupMenu());
    right();
    assertEquals("Turn > Left", selected());
  }

  @Test
  void anEntryWithoutASubmenuAndAMenuOfTheBarAreLeftToSwing() {
    select(bar, file, file.getPopupMenu(), close);
    right();
    select(bar, file, file.getPopupMenu());
    right();
    assertEquals(2, left);
  }
}
