package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.TransferHandler;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.sweep.SweepView;
import org.pendant.desktop.timeline.TimelineView;
import org.pendant.desktop.waveform.WaveformView;
import org.pendant.project.installation.file.InstallationFile;

/** File drop: takes files that people drag onto the window; what is no file of ours is refused. */
@SuppressWarnings("serial") // never written to a stream
final class FileDrop extends TransferHandler {
  /** What file managers offer that know no lists of files: addresses, one a line. */
  static final DataFlavor ADDRESSES =
      new DataFlavor("text/uri-list; class=java.lang.String", text("addressesOfFiles"));

  /** More names than that are counted. */
  private static final int MAX_NAMES = 3;

  private static final List<String> PROGRAMS =
      List.of(ProgramDocument.TREE, ProgramDocument.SCRIPT, ".urscript", ".urp", ".urpx");

  private final transient Consumer<Path> open;
  private final transient Consumer<String> refuse;

  /**
   * Takes files.
   *
   * @param open takes each file of ours
   * @param refuse takes a sentence about the others
   */
  FileDrop(Consumer<Path> open, Consumer<String> refuse) {
    this.open = open;
    this.refuse = refuse;
  }

  @Override
  public boolean canImport(TransferSupport support) {
    return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor)
        || support.isDataFlavorSupported(ADDRESSES);
  }

  @Override
  public boolean importData(TransferSupport support) {
    if (!canImport(support)) {
      return false;
    }
    List<Path> files = new ArrayList<>();
    List<String> others = new ArrayList<>();
    try {
      sort(support.getTransferable(), files, others);
    } catch (UnsupportedFlavorException | IOException e) {
      // The program that offered the files has taken them back; the drop then shows as not taken.
      return false;
    }
    files.forEach(open);
    if (!others.isEmpty()) {
      refuse.accept(refusal(others));
    }
    return !files.isEmpty();
  }

  private static void sort(Transferable dropped, List<Path> files, List<String> others)
      throws UnsupportedFlavorException, IOException {
    if (dropped.isDataFlavorSupported(DataFlavor.javaFileListFlavor)) {
      for (Object each : (List<?>) dropped.getTransferData(DataFlavor.javaFileListFlavor)) {
        sort(((File) each).toPath(), files, others);
      }
      return;
    }
    String lines = (String) dropped.getTransferData(ADDRESSES);
    for (String line : lines.lines().map(String::strip).toList()) {
      Optional<Path> file = file(line);
      if (file.isPresent()) {
        sort(file.get(), files, others);
      } else if (!line.isEmpty() && !line.startsWith("#")) {
        others.add(line);
      }
    }
  }

  private static void sort(Path file, List<Path> files, List<String> others) {
    if (isOurs(file)) {
      files.add(file);
    } else {
      Path name = file.getFileName();
      others.add((name == null ? file : name).toString());
    }
  }

  /** The file of an address on this machine. */
  private static Optional<Path> file(String address) {
    try {
      URI uri = URI.create(address);
      return "file".equalsIgnoreCase(uri.getScheme())
          ? Optional.of(Path.of(uri))
          : Optional.empty();
    } catch (IllegalArgumentException e) {
      // No address, or one of another machine: refused by name.
      return Optional.empty();
    }
  }

  /** Whether the window opens files that are called so. */
  static boolean isOurs(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    return PROGRAMS.stream().anyMatch(name::endsWith)
        || InstallationFile.hasEnding(file.toString())
        || SceneFile.hasEnding(file)
        || TimelineView.isRecording(file)
        || WaveformView.isWaveforms(file)
        || SweepView.isPlan(file);
  }

  private static String refusal(List<String> others) {
    int more = others.size() - MAX_NAMES;
    String names = String.join(", ", others.stream().limit(MAX_NAMES).toList());
    return text(
        "notOpenedTheWindowTakesPrograms",
        more > 0 ? text("andMore", names, more) : names,
        String.join(", ", PROGRAMS));
  }
}
