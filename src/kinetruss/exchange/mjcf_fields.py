"""What becomes of every field of MuJoCo's compiled model: carried, listed where it is not at its default, or without influence.

Names of `mjModel`; those of `mjOption` begin with ``opt.``. A test compares them with the MuJoCo that is installed, and a file
that sets a field that is not here says so.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def _names(text: str) -> tuple[str, ...]:
    """The names of a text; a word that ends with ``_`` or ``.`` stands before the others of its line."""
    found: list[str] = []
    for line in text.split("\n"):
        first, *rest = line.split() or [""]
        found += [first + word for word in rest] if first.endswith(("_", ".")) else line.split()
    return tuple(found)


CARRIED = _names(
    """
    nbody njnt nv nsite neq ntendon nactuator nflex npair qpos0 qpos_spring
    body_ parentid weldid jntnum jntadr pos quat ipos iquat mass inertia contype conaffinity
    jnt_ type qposadr dofadr bodyid pos axis stiffness range
    dof_ jntid frictionloss armature damping
    site_ bodyid pos quat
    geom_bodyid exclude_signature
    eq_ type objtype obj1id obj2id active0 data
    tendon_ type adr num stiffness damping frictionloss lengthspring length0
    wrap_ type objid prm
    actuator_ trntype trnid group outadr ctrlnum gear damping armature
    opt. gravity disableflags disableactuator
    """
)
"""Contacts, among them contype, conaffinity, exclude and pair, are said once if two bodies can touch."""

CONTROL = "of an actuator its joint is carried, and the gear of a hinge if it is above 0; control belongs to a run"
SOFT = "joins, couplings and friction are not softened"
LISTED: Mapping[str, tuple[str, Any, str]] = {
    "body_gravcomp": ("gravcomp", 0, "weight is not compensated"),
    "body_mocapid": ("mocap", -1, "moved bodies rest where they are"),
    "body_plugin": ("plugin", -1, "forces of plugins are not carried"),
    "jnt_limited": ("range", 0, "a model has no limits at joints; those of sliders size their guides"),
    "jnt_actfrclimited": ("actuatorfrcrange", 0, "limits of forces are not carried"),
    "jnt_stiffnesspoly": ("stiffness", 0, "is linear here: the terms of higher order are not carried"),
    "jnt_springyield": ("springyield", 0, "springs stay elastic"),
    "dof_dampingpoly": ("damping", 0, "is linear here: the terms of higher order are not carried"),
    "dof_solref": ("solreffriction", (0.02, 1), SOFT),
    "dof_solimp": ("solimpfriction", (0.9, 0.95, 0.001, 0.5, 2), SOFT),
    "eq_solref": ("solref", (0.02, 1), SOFT),
    "eq_solimp": ("solimp", (0.9, 0.95, 0.001, 0.5, 2), SOFT),
    "tendon_limited": ("range", 0, "limits of tendons are not carried"),
    "tendon_actfrclimited": ("actuatorfrcrange", 0, "limits of forces are not carried"),
    "tendon_armature": ("armature", 0, "is not carried of tendons"),
    "tendon_stiffnesspoly": ("stiffness", 0, "is linear here: the terms of higher order are not carried"),
    "tendon_dampingpoly": ("damping", 0, "is linear here: the terms of higher order are not carried"),
    "tendon_springyield": ("springyield", 0, "springs stay elastic"),
    "tendon_solref_fri": ("solreffriction", (0.02, 1), SOFT),
    "tendon_solimp_fri": ("solimpfriction", (0.9, 0.95, 0.001, 0.5, 2), SOFT),
    "actuator_dyntype": ("dyntype", 0, CONTROL),
    "actuator_dynprm": ("dynprm", (1, 0, 0, 0, 0, 0, 0, 0, 0, 0), CONTROL),
    "actuator_gaintype": ("gaintype", 0, CONTROL),
    "actuator_gainprm": ("gainprm", (1, 0, 0, 0, 0, 0, 0, 0, 0, 0), CONTROL),
    "actuator_biastype": ("biastype", 0, CONTROL),
    "actuator_biasprm": ("biasprm", 0, CONTROL),
    "actuator_ctrlspec": ("ctrlspec", 0, CONTROL),
    "actuator_ctrllimited": ("ctrlrange", 0, CONTROL),
    "actuator_actlimited": ("actrange", 0, CONTROL),
    "actuator_forcelimited": ("forcerange", 0, CONTROL),
    "actuator_actearly": ("actearly", 0, CONTROL),
    "actuator_delay": ("delay", 0, CONTROL),
    "actuator_dampingpoly": ("damping of higher order", 0, CONTROL),
    "actuator_plugin": ("plugin", -1, CONTROL),
    "opt.density": ("density", 0, "forces of a medium on bodies are not carried"),
    "opt.viscosity": ("viscosity", 0, "forces of a medium on bodies are not carried"),
    "opt.wind": ("wind", 0, "forces of a medium on bodies are not carried"),
    "opt.enableflags": ("flag", 0, "see the flags"),
}
"""Field -> attribute, default, reason. `flex` counts too: its elasticity is not carried."""

WITHOUT_INFLUENCE: Mapping[str, tuple[str, ...]] = {
    "belongs to a limit, a plugin, an actuator or a rule of sleep, which is listed itself": _names(
        """
        plugin body_margin tree_sleep_policy opt.sleep_tolerance
        jnt_ actgravcomp solref solimp actfrcrange margin
        tendon_ solref_lim solimp_lim range actfrcrange margin
        actuator_ cranklength actrange history forcerange ctrlrange lengthrange
        plugin_ stateadr statenum attr attradr
        """
    ),
    "counts, addresses, names, and what follows from other fields": _names(
        """
        nq nu nout na nbvh nbvhstatic nbvhdynamic noct ntree nM nB nC nD ngeom ncam nlight nflexnode nflexvert nflexedge
        nflexelem nflexelemdata nflexstiffness nflexbending nefm0dof nefm0L nefmCvert nflexelemedge nflexshelldata
        nflextexcoord nJfe nmesh nmeshvert nmeshnormal nmeshtexcoord nmeshface nmeshgraph nmeshpoly nmeshpolyvert
        nmeshpolymap nskin nskinvert nskintexvert nskinface nskinbone nskinbonevert nhfield nhfielddata ntex ntexdata
        nmat nexclude nJten nwrap nsensor nnumeric nnumericdata ntext ntextdata ntuple ntupledata nkey nmocap nplugin
        npluginattr nnames npaths nplastic nJmom ngravcomp nemax njmax nconmax npolygonmax nmeshdegmax nuserdata
        nsensordata npluginstate nhistory narena nbuffer stat buffer names paths mapM2M mapM2D mapD2M signature
        nnames_map jnt_actuatorid jnt_plasticadr site_sameframe names_map
        nuser_ body jnt geom site cam tendon actuator sensor
        flg_ gravcomp surfacevel adhesion
        body_ rootid dofnum dofadr treeid geomnum geomadr simple sameframe subtreemass invweight0 bvhadr bvhnum
        bvh_ depth child nodeid aabb
        oct_ depth child aabb coeff
        dof_ bodyid parentid treeid Madr simplenum invweight0 M0 length
        tree_ bodyadr bodynum dofadr dofnum
        tendon_ actuatorid plasticadr treenum treeid invweight0
        ten_ J_rownnz J_rowadr J_colind
        actuator_ ctrladr outnum actadr actnum historyadr acc0 length0
        name_ bodyadr jntadr geomadr siteadr camadr lightadr flexadr meshadr skinadr hfieldadr texadr matadr pairadr
        name_ excludeadr eqadr tendonadr actuatoradr sensoradr numericadr textadr tupleadr keyadr pluginadr
        B_ rownnz rowadr colind
        M_ rownnz rowadr colind
        D_ rownnz rowadr diag colind
        """
    ),
    "shapes and their contact: that two bodies can touch is listed once": _names(
        """
        geom_ type contype conaffinity condim dataid matid group priority plugin sameframe castshadow solmix solref
        geom_ solimp size aabb rbound pos quat friction margin gap surfacevel adhesion fluid rgba
        mesh_ vertadr vertnum faceadr facenum bvhadr bvhnum octadr octnum normaladr normalnum texcoordadr texcoordnum
        mesh_ graphadr extrema vert normal texcoord face facenormal facetexcoord graph scale pos quat pathadr polynum
        mesh_ polyadr polynormal polyvertadr polyvertnum polyvert polymapadr polymapnum polymap
        hfield_ size nrow ncol adr data pathadr
        pair_ dim geom1 geom2 signature solref solreffriction solimp margin gap adhesion friction
        """
    ),
    "deformable bodies: each flex is listed": _names(
        """
        efmC_perm
        flex_ contype conaffinity condim priority solmix solref solimp friction margin gap selfcollide activelayers
        flex_ passive dim matid group interp cellnum nodeadr nodenum vertadr vertnum edgeadr edgenum elemadr elemnum
        flex_ elemdataadr stiffnessadr elemedgeadr bendingadr plasticadr plasticmode shellnum shelldataadr
        flex_ texcoordadr nodebodyid vertbodyid vertcell edge edgeflap elem elemtexcoord elemedge elemlayer shell
        flex_ vert vert0 node node0 radius size stiffness bending damping yield edgestiffness edgedamping
        flex_ edgeequality rigid centered flatskin bvhadr bvhnum rgba texcoord
        flexedge_ length0 invweight0 rigid J_rownnz J_rowadr J_colind
        efm0_ dofid L_rownnz L_rowadr L_colind L
        """
    ),
    "appearance": _names(
        """
        vis jnt_group
        site_ type dataid matid group size rgba
        cam_ mode bodyid targetbodyid pos quat poscom0 pos0 mat0 projection fovy ipd resolution output sensorsize
        cam_ intrinsic user
        light_ mode bodyid targetbodyid type texid castshadow bulbradius intensity range active pos dir poscom0 pos0
        light_ dir0 attenuation cutoff softness exponent ambient diffuse specular
        skin_ matid group rgba inflate vertadr vertnum texcoordadr faceadr facenum boneadr bonenum vert texcoord face
        skin_ bonevertadr bonevertnum bonebindpos bonebindquat bonebodyid bonevertid bonevertweight pathadr
        tex_ type colorspace height width nchannel adr data pathadr contenttypeadr
        mat_ texid texuniform texrepeat emission specular shininess reflectance metallic roughness rgba
        tendon_ matid group width rgba
        """
    ),
    "sensors, poses and data of the user": _names(
        """
        body_user jnt_user geom_user site_user tendon_user actuator_user
        sensor_ type datatype needstage objtype objid reftype refid intprm dim adr cutoff noise history historyadr
        sensor_ delay interval user plugin
        numeric_ adr size data
        text_ adr size data
        tuple_ adr size objtype objid objprm
        key_ time qpos qvel act mpos mquat ctrl plastic
        """
    ),
    "settings of MuJoCo's solvers and of its sensors, not of the equations of motion": _names(
        """
        opt. timestep impratio tolerance ls_tolerance noslip_tolerance ccd_tolerance magnetic o_margin o_solref
        opt. o_solimp o_friction integrator cone jacobian solver iterations ls_iterations noslip_iterations
        opt. ccd_iterations sdf_initpoints sdf_iterations
        """
    ),
}

FLAGS: Mapping[str, tuple[str, ...]] = {
    "carried": _names("CONSTRAINT EQUALITY FRICTIONLOSS LIMIT CONTACT SPRING DAMPER GRAVITY FILTERPARENT ACTUATION"),
    "listed": _names("SLEEP"),
    "without influence on motion": _names(
        """
        CLAMPCTRL WARMSTART REFSAFE SENSOR MIDPHASE EULERDAMP AUTORESET NATIVECCD ISLAND MULTICCD
        OVERRIDE ENERGY FWDINV INVDISCRETE DIAGEXACT IPC SPECULATIVE
        """
    ),
}
"""What becomes of the bits of `opt.disableflags` and `opt.enableflags`."""

KNOWN = frozenset((*CARRIED, *LISTED, *(name for names in WITHOUT_INFLUENCE.values() for name in names)))
"""All fields; records and texts are among them by their names."""
