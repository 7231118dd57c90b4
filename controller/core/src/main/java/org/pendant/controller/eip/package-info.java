/**
 * EtherNet/IP assemblies that programs and a scanner exchange (manual 21). Open {@link
 * org.pendant.controller.eip.Assemblies} first.
 */
package org.pendant.controller.eip;
