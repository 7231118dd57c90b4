package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.desktop.program.Trees.comment;
import static org.pendant.desktop.program.Trees.folder;

import java.awt.EventQueue;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.project.program.ProgramTree;

final class TreeListTest {
  private static final long FOLDER = 2;
  private static final long INSIDE = 3;

  private TreeList list;

  @Test
  void aNodeThatIsFoldedAwayHandsItsSelectionToTheFoldedOne() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          open();
          list.select(INSIDE);
          list.setFolded(FOLDER, true);
          assertEquals(Set.of(FOLDER), list.selected());
          assertEquals(OptionalLong.of(FOLDER), list.lead());
        });
  }

  @Test
  void aNodeThatIsGoneIsNotSelectedAnyMore() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          open();
          list.select(INSIDE);
          list.show(list.tree().remove(List.of(INSIDE)));
          assertEquals(Set.of(), list.selected());
        });
  }

  private void open() {
    ProgramTree tree = Trees.of(folder("Fetch", comment("down")), comment("home"));
    list = new TreeList();
    list.show(tree);
  }
}
