package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.TransferHandler.TransferSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files that are dragged from a file manager onto the window. */
final class FileDropTest {
  private final List<Path> opened = new ArrayList<>();
  private final List<String> refused = new ArrayList<>();
  private final FileDrop drop = new FileDrop(opened::add, refused::add);

  /** What a file manager offers in one form; null if it has taken that back. */
  private record Offer(DataFlavor flavor, Object what) implements Transferable {
    @Override
    public DataFlavor[] getTransferDataFlavors() {
      return new DataFlavor[] {flavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor asked) {
      return flavor.equals(asked);
    }

    @Override
    public Object getTransferData(DataFlavor asked) throws UnsupportedFlavorException, IOException {
      if (!isDataFlavorSupported(asked)) {
        throw new UnsupportedFlavorException(asked);
      }
      if (what == null) {
        throw new IOException("taken back");
      }
      return what;
    }
  }

  private static Offer files(String... paths) {
    return new Offer(DataFlavor.javaFileListFlavor, Stream.of(paths).map(File::new).toList());
  }

  private boolean drop(Transferable offer) {
    return drop.importData(new TransferSupport(new JPanel(), offer));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "weld.pendant",
        "weld.script",
        "Weld.SCRIPT",
        "weld.urscript",
        "weld.urp",
        "weld.urpx",
        "cell.pinst",
        "cell.installation",
        "table.scene.json",
        "night.rec",
        "speeds.toml",
        "signals.csv"
      })
  void filesOfOursAreOpened(String name) {
    assertTrue(drop(files("/programs/" + name)));
    assertEquals(List.of(Path.of("/programs/" + name)), opened);
    assertEquals(List.of(), refused);
  }

  @Test
  void addressesOfFilesAreOpenedToo() {
    String lines = "# from a file manager\r\nfile:///programs/two%20parts.script\r\n";
    assertTrue(drop(new Offer(FileDrop.ADDRESSES, lines)));
    assertEquals(List.of(Path.of("/programs/two parts.script")), opened);
    assertEquals(List.of(), refused);
  }

  @Test
  void othersAreRefusedByNameAndDoNotKeepOursOut() {
    assertTrue(drop(files("/p/photo.png", "/p/weld.script", "/p/folder")));
    assertEquals(List.of(Path.of("/p/weld.script")), opened);
    assertEquals(1, refused.size());
    String said = refused.getFirst();
    assertTrue(said.startsWith("Not opened: photo.png, folder. The window takes programs"), said);
  }

  @Test
  void manyOthersAreCounted() {
    assertFalse(drop(files("/p/a.png", "/p/b.png", "/p/c.png", "/p/d.png", "/p/e.png")));
    String said = refused.getFirst();
    assertTrue(said.startsWith("Not opened: a.png, b.png, c.png and 2 more. "), said);
  }

  @Test
  void addressesElsewhereAreRefused() {
    assertFalse(
        drop(new Offer(FileDrop.ADDRESSES, "https://example.org/weld.script\nno address\n")));
    assertEquals(List.of(), opened);
    String said = refused.getFirst();
    assertTrue(said.startsWith("Not opened: https://example.org/weld.script, no address."), said);
  }

  @Test
  void textIsNoFile() {
    StringSelection text = new StringSelection("/p/weld.script");
    assertFalse(drop.canImport(new TransferSupport(new JPanel(), text)));
    assertFalse(drop(text));
    assertEquals(List.of(), opened);
  }

  @Test
  void offerThatIsTakenBackOpensNothing() {
    assertFalse(drop(new Offer(DataFlavor.javaFileListFlavor, null)));
    assertEquals(List.of(), opened);
    assertEquals(List.of(), refused);
  }
}
