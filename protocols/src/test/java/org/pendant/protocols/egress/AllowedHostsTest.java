package org.pendant.protocols.egress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import org.junit.jupiter.api.Test;

class AllowedHostsTest {

  private static boolean allows(String text, String name, String address) {
    return AllowedHosts.parse(text).allows(name, InetAddress.ofLiteral(address));
  }

  @Test
  void anyAllowsAllAndNoneNothing() {
    assertTrue(allows("any", "peer", "10.0.0.1"));
    assertFalse(allows("none", "peer", "10.0.0.1"));
    assertFalse(allows("none", "127.0.0.1", "127.0.0.1"));
  }

  @Test
  void aNetworkAllowsTheAddressesInItWhateverTheirNames() {
    assertTrue(allows("192.168.4.0/22", "peer", "192.168.7.255"));
    assertFalse(allows("192.168.4.0/22", "peer", "192.168.8.0"));
    assertTrue(allows("10.0.0.7", "10.0.0.7", "10.0.0.7"));
    assertFalse(allows("10.0.0.7", "10.0.0.8", "10.0.0.8"));
    assertTrue(allows("fd00::/8", "peer", "fd12::1"));
    assertFalse(allows("0.0.0.0/0", "peer", "::1"));
  }

  @Test
  void aNameAllowsTheHostThatIsCalledSo() {
    assertTrue(allows("camera.local, 10.0.0.7", "Camera.Local", "10.0.0.3"));
    assertFalse(allows("camera.local", "10.0.0.3", "10.0.0.3"));
  }

  @Test
  void localhostAllowsThisComputerByEveryName() {
    assertTrue(allows("localhost", "127.0.0.1", "127.0.0.1"));
    assertTrue(allows("localhost", "::1", "::1"));
    assertFalse(allows("localhost", "10.0.0.1", "10.0.0.1"));
  }

  @Test
  void refusesWhatIsNoHost() {
    for (String wrong :
        new String[] {"", "a,,b", "10.0.0.0/33", "10.0.0.0/", "x/8", "a b", "-a", "::/129"}) {
      assertThrows(IllegalArgumentException.class, () -> AllowedHosts.parse(wrong), wrong);
    }
    assertEquals(
        "\"10.0.0.0/33\" is no host, must be a name, an address or a network such as"
            + " 192.168.0.0/24",
        assertThrows(IllegalArgumentException.class, () -> AllowedHosts.parse("10.0.0.0/33"))
            .getMessage());
  }
}
