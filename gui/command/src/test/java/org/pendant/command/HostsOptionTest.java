package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.egress.AllowedHosts;

final class HostsOptionTest {
  private static final InetAddress SOMEWHERE = InetAddress.ofLiteral("10.1.2.3");

  private static AllowedHosts hosts(String... words) throws UsageException {
    return HostsOption.of(Arguments.parse(List.of(HostsOption.OPTION), List.of(words)));
  }

  @Test
  void everyHostIsAllowedUnlessSomeAreNamed() throws UsageException {
    assertTrue(hosts().allows("peer", SOMEWHERE));
    assertTrue(hosts("--allow-hosts=10.0.0.0/8").allows("peer", SOMEWHERE));
    assertFalse(hosts("--allow-hosts=none").allows("peer", SOMEWHERE));
  }

  @Test
  void refusesWhatIsNoHost() {
    assertEquals(
        "--allow-hosts: \"a b\" is no host, must be a name, an address or a network such as"
            + " 192.168.0.0/24",
        assertThrows(UsageException.class, () -> hosts("--allow-hosts=a b")).getMessage());
  }
}
