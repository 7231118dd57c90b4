/**
 * EtherNet/IP adapter of a control box: explicit messages by TCP, cyclic data by UDP, and the
 * service that configures assemblies. Open {@link org.pendant.protocols.eip.EipServer} first.
 */
package org.pendant.protocols.eip;
