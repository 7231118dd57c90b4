/**
 * External Control: asking drivers for the script of its nodes, as the URCap of that name does.
 * Open {@link org.pendant.protocols.externalcontrol.Drivers} first.
 */
package org.pendant.protocols.externalcontrol;
