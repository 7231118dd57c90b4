package org.pendant.desktop.shell;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.OpenFiles;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.kit.background.Background;

/** Other windows: tells people that a file is open in another window too. */
final class OtherWindows {
  /** Name of the notice. */
  private static final String NOTICE = "other-window";

  private final Programs programs;
  private final ActiveInstallation installation;
  private final OpenFiles openFiles;
  private final Notices notices;
  private final Consumer<String> tell;
  private List<Path> known = List.of();
  private boolean busy;
  private boolean troubleTold;

  OtherWindows(
      Programs programs,
      ActiveInstallation installation,
      OpenFiles openFiles,
      Notices notices,
      Consumer<String> tell) {
    this.programs = programs;
    this.installation = installation;
    this.openFiles = openFiles;
    this.notices = notices;
    this.tell = tell;
  }

  /** Looks what other windows have open; called every few seconds and when files are opened. */
  void look() {
    if (busy) {
      return;
    }
    busy = true;
    List<Path> open =
        Stream.concat(programs.all().stream(), Stream.of(installation.document()))
            .map(ProgramDocument::file)
            .flatMap(Optional::stream)
            .toList();
    Background.run(
        () -> openFiles.share(open),
        shared -> {
          busy = false;
          troubleTold = false;
          show(shared);
        },
        failed -> {
          busy = false;
          if (!troubleTold) {
            troubleTold = true;
            tell.accept(
                ShellTexts.text("whetherAnotherWindowHasTheSame", FileTrouble.reason(failed)));
          }
        });
  }

  private void show(List<Path> shared) {
    boolean more = !known.containsAll(shared);
    boolean fewer = !shared.containsAll(known);
    known = shared;
    if (shared.isEmpty()) {
      notices.close(NOTICE);
    } else if (more || (fewer && notices.shows(NOTICE))) {
      notices.tell(NOTICE, text(shared));
    }
  }

  private static String text(List<Path> shared) {
    String names =
        String.join(", ", shared.stream().map(file -> String.valueOf(file.getFileName())).toList());
    return shared.size() == 1
        ? ShellTexts.text("isOpenInAnotherPendantWindow", names)
        : ShellTexts.text("openInAnotherPendantWindowToo", names);
  }

  /** The window closes. */
  void end() {
    try {
      openFiles.close();
    } catch (IOException e) {
      // Other windows see that this process is no more.
      tell.accept(ShellTexts.text("notRemoved", FileTrouble.reason(e)));
    }
  }
}
