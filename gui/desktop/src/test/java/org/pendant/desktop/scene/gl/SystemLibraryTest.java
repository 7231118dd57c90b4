package org.pendant.desktop.scene.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.lwjgl.system.Configuration;
import org.pendant.protocols.natives.NativeFolder;

@EnabledOnOs(OS.LINUX)
final class SystemLibraryTest {
  @BeforeAll
  static void unpackWhereTheDesktopDoes() throws IOException {
    Configuration.SHARED_LIBRARY_EXTRACT_PATH.set(NativeFolder.ofUser().toString());
  }

  @Test
  void aLibraryIsFoundByItsName() {
    Path path = SystemLibrary.path("libm.so.6").orElseThrow();
    assertTrue(path.isAbsolute(), path::toString);
    assertTrue(Files.exists(path), path::toString);
  }

  @Test
  void aLibraryThatThereIsNotHasNoPlace() {
    assertEquals(Optional.empty(), SystemLibrary.path("libnothing.so.9"));
  }
}
