/**
 * Dashboard server: a line of text asks for what a button of the teach pendant does, and a line
 * answers. Open {@link org.pendant.protocols.dashboard.DashboardServer} first.
 */
package org.pendant.protocols.dashboard;
