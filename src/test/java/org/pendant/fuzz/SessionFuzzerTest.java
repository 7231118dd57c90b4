package org.pendant.fuzz;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Tag("slow")
class SessionFuzzerTest {
  /** A second or two. */
  private static final int SESSIONS = 120;

  /** Builds repeat; mvn -Pfuzz-sessions takes others. */
  private static final long SEED = 7;

  @TempDir Path folder;

  @Test
  @Timeout(300)
  void nothingIsLeftOfRandomClientsAndEveryPortStillAnswers() throws Exception {
    try (SessionFuzzer fuzzer = new SessionFuzzer(SEED, folder)) {
      assertEquals(Optional.empty(), fuzzer.run(SESSIONS));
    }
  }
}
