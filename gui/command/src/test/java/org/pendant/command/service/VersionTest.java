package org.pendant.command.service;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;

final class VersionTest {

  private static Optional<String> commit(String file) throws IOException {
    return Version.commit(new ByteArrayInputStream(file.getBytes(StandardCharsets.ISO_8859_1)));
  }

  @Test
  void commitIsToldWithItsDay() throws IOException {
    assertEquals(
        Optional.of("30dd574f of 2026-11-28"),
        commit("git.commit.id.abbrev=30dd574f\ngit.commit.time=2026-11-28\n"));
  }

  @Test
  void withoutARepositoryThereIsNone() throws IOException {
    assertEquals(Optional.empty(), commit("git.commit.id.abbrev=\n"));
  }
}
