/**
 * The assemblies that programs and an EtherNet/IP scanner exchange (manual 21). Open {@link
 * org.pendant.controller.eip.Assemblies} first.
 */
package org.pendant.controller.eip;
