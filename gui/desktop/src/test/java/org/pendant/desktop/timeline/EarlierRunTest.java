package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class EarlierRunTest {
  @TempDir Path folder;

  @Test
  void aComparisonTellsAtOnceThatItGoesOnAsItMayTakeLong() {
    RecordedRun run = new RecordedRun().start("sleep(0.1)\n").frames(100);
    PreviewWorkbench workbench = new PreviewWorkbench();
    new EarlierRun(workbench, new LookBack(run.ring::recording, text -> {}), line -> "line " + line)
        .compareWith(folder.resolve("yesterday.rec"));
    assertEquals(List.of("Comparing the last run with yesterday.rec\u2026"), workbench.told());
  }
}
