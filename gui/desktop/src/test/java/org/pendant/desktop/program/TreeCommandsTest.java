package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.desktop.program.Trees.MAIN;
import static org.pendant.desktop.program.Trees.comment;
import static org.pendant.desktop.program.Trees.folder;
import static org.pendant.desktop.program.Trees.shown;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.text.ProgramText;

final class TreeCommandsTest {
  private final Set<Long> selected = new LinkedHashSet<>();
  private final List<String> told = new ArrayList<>();
  private String clipboard = "";
  private final TreeProgram program =
      program(ProgramText.write(Trees.of(comment("a"), folder("F", comment("b")), comment("d"))));
  private final TreeCommands commands = new TreeCommands(new Picked(), new Board(), told::add);

  TreeCommandsTest() {
    commands.setProgram(Optional.of(program));
  }

  private static TreeProgram program(String text) {
    return new TreeProgram(
        ProgramDocument.untitled("test.pendant", text),
        () -> Installation.NONE,
        work -> {},
        Runnable::run,
        (shown, before, now) -> {},
        () -> 0);
  }

  /** What a test selects. */
  private final class Picked implements TreeCommands.Selection {
    @Override
    public Set<Long> selected() {
      return selected;
    }

    @Override
    public OptionalLong lead() {
      return selected.stream().mapToLong(Long::longValue).reduce((a, b) -> b);
    }

    @Override
    public void select(Collection<Long> keys) {
      selected.clear();
      selected.addAll(keys);
    }
  }

  /** A clipboard of the test's own. */
  private final class Board implements TreeCommands.Clipboard {
    @Override
    public String get() {
      return clipboard;
    }

    @Override
    public void put(String text) {
      clipboard = text;
    }
  }

  private void select(Long... keys) {
    selected.clear();
    selected.addAll(List.of(keys));
  }

  private String tree() {
    return shown(program.tree());
  }

  @Test
  void addsAndSelectsWhatItAdded() {
    select(2L);
    commands.add(NodeKind.HALT);
    assertEquals("a Halt F .b d", tree());
    commands.add(NodeKind.FOLDER);
    commands.add(NodeKind.HALT);
    assertEquals("a Halt Folder .Halt F .b d", tree());
  }

  @Test
  void saysWhereNothingCanBeAdded() {
    select(2L);
    commands.add(NodeKind.CASE);
    assertEquals("a F .b d", tree());
    assertTrue(told.getFirst().startsWith("Case has no place"), told.toString());
  }

  @Test
  void cutsAndPastesIntoOrBehind() {
    select(2L, 5L);
    commands.cut();
    assertEquals("F .b", tree());
    select(3L);
    commands.paste();
    assertEquals("F .b .a .d", tree());
    assertEquals(2, selected.size());
  }

  @Test
  void aFolderThatWasCopiedIsPastedBesideItself() {
    select(3L);
    commands.copy();
    commands.paste();
    assertEquals("a F .b F .b d", tree());
  }

  @Test
  void pastesTextThatWasWrittenElsewhere() {
    clipboard = "pendant nodes 1\ncomment text=\"typed\"\n";
    select(2L);
    commands.paste();
    assertEquals("a typed F .b d", tree());
    clipboard = "movej([0,0,0,0,0,0])";
    commands.paste();
    assertEquals("a typed F .b d", tree());
    assertEquals("There are no nodes on the clipboard", told.getLast());
  }

  @Test
  void theMainProgramStays() {
    select(MAIN);
    commands.delete();
    assertEquals("a F .b d", tree());
    assertEquals(1, told.size());
  }

  @Test
  void undoSaysWhatAndSelectsWhatCameBack() {
    select(3L);
    commands.delete();
    assertEquals(Set.of(5L), selected);
    commands.undo();
    assertEquals("a F .b d", tree());
    assertEquals(Set.of(3L), selected);
    assertTrue(told.getLast().startsWith("Undone: delete "), told.toString());
    commands.redo();
    assertEquals("a d", tree());
  }

  @Test
  void shiftsTheSelectedNodes() {
    select(2L);
    commands.shift(true);
    assertEquals("F .b a d", tree());
    commands.shift(false);
    assertEquals("a F .b d", tree());
    assertEquals(Set.of(2L), selected);
  }

  @Test
  void droppedNodesAreMovedOrCopied() {
    TreeDrag.Cargo moved = new TreeDrag.Cargo(program.tree().childrenOf(3), true, false);
    commands.drop(moved, new Spot(MAIN, 0));
    assertEquals("b a F d", tree());
    TreeDrag.Cargo copied =
        new TreeDrag.Cargo(List.of(program.tree().find(2).orElseThrow()), true, true);
    commands.drop(copied, new Spot(3, 0));
    assertEquals("b a F .a d", tree());
  }

  @Test
  void scriptBecomesNodes() {
    select(2L);
    commands.addScript("textmsg(1)\nsync()");
    assertEquals("a textmsg(1) sync() F .b d", tree());
  }
}
