package org.pendant.testing.coverage;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.CoverageMap;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.testing.builtin.TestBuiltins;
import org.pendant.testing.source.MockedFunctions;

/** What makes functions of a program replaceable is no part of what can be reached of it. */
class MockedCoverageTest {
  private static List<String> places(CoverageMap map) {
    return map.sites().stream()
        .map(site -> site.line() + " " + site.kind() + " " + map.source().text(site.range()))
        .toList();
  }

  @Test
  void aProgramWithMockedFunctionsHasThePlacesOfItsText() {
    MockedFunctions mocked = new MockedFunctions(Set.of("grip", "unused"));
    CoverageMap map =
        ProgramLoader.load(
                Source.of("cell/pick.script", SampleCoverage.PICK),
                mocked::into,
                mocked.builtins(TestBuiltins.create()),
                true)
            .program()
            .orElseThrow()
            .coverageMap()
            .orElseThrow();
    assertEquals(Set.of("grip", "unused"), mocked.found());
    assertEquals(places(SampleCoverage.map("cell/pick.script", SampleCoverage.PICK)), places(map));
  }
}
